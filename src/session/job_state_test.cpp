#include "session/job_state.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

using Marks = std::vector<JobState::ErrorMark>;

TEST(JobState, SharesOfTheWorkAreDisjointAndComplete) {
  for (const std::uint64_t count : {1U, 2U, 3U, 7U}) {
    std::uint64_t items = 0;
    for (std::uint64_t item = 0; item < 20; ++item) {
      std::uint64_t owners = 0;
      for (std::uint64_t i = 0; i < count; ++i) owners += WorkShare{i, count}.has(item) ? 1 : 0;
      EXPECT_EQ(owners, 1U);
    }
    for (std::uint64_t i = 0; i < count; ++i) items += WorkShare{i, count}.size(20);
    EXPECT_EQ(items, 20U);
  }
}

TEST(JobState, APartialPassCountsInPart) {
  JobState state;
  state.samples_per_pixel = 8;
  state.partial = PartialPass{8, 4, {1, 1, 1, 0}};
  EXPECT_EQ(state.mean_samples(), 11U);
  state.samples_per_pixel = 0;
  state.partial = PartialPass{0, 1, {0, 1, 0, 0}};
  EXPECT_EQ(state.mean_samples(), 1U);
}

TEST(TargetError, IsReachedWhenThreeEstimatesAgree) {
  EXPECT_TRUE(target_is_reached({{16, 0.02}, {24, 0.0163}, {32, 0.0141}}, 0.015));
  EXPECT_FALSE(target_is_reached({{24, 0.0163}, {32, 0.0141}}, 0.015));
  EXPECT_FALSE(target_is_reached({}, 0.015));
}

TEST(TargetError, IsNotReachedByASingleLowEstimate) {
  // The earlier two say that 32 samples have an error of 0.028.
  EXPECT_FALSE(target_is_reached({{16, 0.04}, {24, 0.033}, {32, 0.01}}, 0.015));
  // Nor right after a firefly was found, however low the others were.
  EXPECT_FALSE(target_is_reached({{16, 0.01}, {24, 0.01}, {32, 0.05}}, 0.015));
}

TEST(TargetError, ForgetsWhatIsLongAgo) {
  Marks marks = {{4, 9.0}, {8, 0.1}, {16, 0.02}, {24, 0.0163}, {32, 0.0141}};
  forget_old_errors(marks);
  ASSERT_EQ(marks.size(), 3U);
  EXPECT_EQ(marks.front().samples, 16U);
}

}  // namespace
}  // namespace ajar
