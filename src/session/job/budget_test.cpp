#include "session/job/budget.h"

#include <gtest/gtest.h>

#include <vector>

namespace ajar {
namespace {

/// Sample counts after each pass when the clock never matters.
std::vector<std::uint64_t> sums(const PassSchedule& schedule) {
  std::vector<std::uint64_t> result;
  PassHistory history;
  while (const std::uint64_t samples = schedule.next_pass(history)) {
    history.samples_done += samples;
    result.push_back(history.samples_done);
  }
  return result;
}

TEST(PassSchedule, GrowsThroughMilestones) {
  const PassSchedule schedule({64, {}, {}}, 4, 1.0);
  EXPECT_EQ(sums(schedule), (std::vector<std::uint64_t>{1, 4, 8, 12, 16, 24, 32, 48, 64}));
}

TEST(PassSchedule, EndsAtTheBudgetRoundedUp) {
  EXPECT_EQ(PassSchedule({61, {}, {}}, 4, 1.0).total(), 64U);
  EXPECT_EQ(PassSchedule({64, {}, {}}, 4, 1.0).total(), 64U);
  EXPECT_EQ(PassSchedule({1, {}, {}}, 1, 1.0).total(), 1U);
  EXPECT_EQ(sums(PassSchedule({20, {}, {}}, 4, 1.0)),
            (std::vector<std::uint64_t>{1, 4, 8, 12, 16, 20}));
}

TEST(PassSchedule, EveryMilestoneIsAMultipleOfTheReplicates) {
  for (const int replicates : {1, 2, 3, 4, 5}) {
    const PassSchedule schedule({5000, {}, {}}, replicates, 1.0);
    std::vector<std::uint64_t> after = sums(schedule);
    after.erase(after.begin());  // the first pass is the shortest there is
    for (const std::uint64_t sum : after) {
      EXPECT_EQ(sum % static_cast<std::uint64_t>(replicates), 0U);
      EXPECT_TRUE(schedule.is_milestone(sum)) << sum;
    }
  }
}

TEST(PassSchedule, OtherCountsAreNoMilestones) {
  const PassSchedule schedule({1000, {}, {}}, 4, 1.0);
  for (const std::uint64_t sum : {0U, 20U, 28U, 40U, 56U}) EXPECT_FALSE(schedule.is_milestone(sum));
  EXPECT_TRUE(schedule.is_milestone(1000));
}

TEST(PassSchedule, CutsSlowPasses) {
  const PassSchedule schedule({1024, {}, {}}, 4, 0.5);
  // 256 more samples would reach the next milestone; at 10 ms each, 50 fit into half a second.
  EXPECT_EQ(schedule.next_pass({256, 3.0, 0.01}), 50U);
  EXPECT_EQ(schedule.next_pass({256, 3.0, 1.0}), 1U);
  EXPECT_EQ(schedule.next_pass({256, 3.0, 0.0}), 128U);
}

TEST(PassSchedule, DoesNotBeginWhatLiesBeyondTheTimeLimit) {
  const PassSchedule schedule({{}, 10.0, {}}, 4, 0.5);
  EXPECT_EQ(schedule.next_pass({64, 10.0, 0.01}), 0U);
  EXPECT_EQ(schedule.next_pass({64, 9.0, 4.0}), 0U);    // 4 s for the smallest pass, 1 s left
  EXPECT_EQ(schedule.next_pass({64, 7.5, 4.0}), 1U);    // mostly inside
  EXPECT_EQ(schedule.next_pass({64, 9.92, 0.01}), 8U);  // 80 ms left
}

TEST(SecondsOfPasses, LeaveTimeForWhatFollows) {
  EXPECT_DOUBLE_EQ(seconds_of_passes(20.0, 2.0, 0.0, 3.0), 15.0);
  EXPECT_DOUBLE_EQ(seconds_of_passes(20.0, 2.0, 0.0, 0.0), 18.0);
  EXPECT_DOUBLE_EQ(seconds_of_passes(20.0, 2.0, 0.0, 100.0), 9.0) << "half of what is left";
  EXPECT_DOUBLE_EQ(seconds_of_passes(20.0, 30.0, 0.0, 3.0), 0.0);
  EXPECT_DOUBLE_EQ(seconds_of_passes(20.0, 6.0, 4.0, 3.0), 11.0)
      << "samples that are kept are passes";
  EXPECT_DOUBLE_EQ(seconds_of_passes(20.0, 6.0, 4.0, 100.0), 5.0);
  EXPECT_DOUBLE_EQ(seconds_of_passes(20.0, 16.0, 14.0, 100.0), 0.0);
}

TEST(PassSchedule, AlwaysHasAFirstPass) {
  EXPECT_EQ(PassSchedule({{}, 1e-9, {}}, 4, 0.5).next_pass({}), 1U);
}

}  // namespace
}  // namespace ajar
