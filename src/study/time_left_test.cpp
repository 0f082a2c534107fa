#include "study/time_left.h"

#include <gtest/gtest.h>

namespace ajar::study {
namespace {

TEST(TimeLeft, UsesTimeLimitsAndMeasuredSpeed) {
  StudyPlan plan;
  plan.budgets = {{10.0, std::nullopt}, {std::nullopt, 8}, {std::nullopt, 32}};
  std::vector<StudyRun> runs(4);
  runs[0].budget = 0;
  runs[0].seconds = 10.0;
  runs[1].budget = 1;
  runs[2].budget = 2;
  runs[3].budget = 2;
  runs[3].method = 1;
  std::vector<std::optional<RunRecord>> records(4);
  EXPECT_FALSE(seconds_left(plan, runs, records, 0)) << "nobody knows how long a sample takes";
  records[1] = RunRecord{{{"seconds", 4.0}}};
  // 10 s by its limit, 32 samples of half a second, and the mean of all for a method never seen.
  EXPECT_DOUBLE_EQ(seconds_left(plan, runs, records, 0).value(), 10.0 + 16.0 + 4.0);
  EXPECT_DOUBLE_EQ(seconds_left(plan, runs, records, 3).value(), 4.0);
}

}  // namespace
}  // namespace ajar::study
