#include "integrator/montecarlo/weighted_errors.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

const Box2i kTwoPixels(Vec2i(3, 5), Vec2i(4, 5));

TEST(WeightedErrors, WeighLuminanceByImportance) {
  // Two pixels; weights are scaled to a mean of 1.
  const ImportanceMap importance(kTwoPixels, {3.F, 1.F});
  const Replicates replicates = {{1.F, 1.F, 1.F, 2.F, 2.F, 2.F}, {3.F, 3.F, 3.F, 2.F, 2.F, 2.F}};
  const auto light = weighted_light(replicates, kTwoPixels, importance);
  EXPECT_NEAR(light[0][0], 1.5F, 1e-5F);
  EXPECT_NEAR(light[1][0], 4.5F, 1e-5F);
  EXPECT_NEAR(light[0][1], 1.F, 1e-5F);
  const WeightedErrors errors = weighted_errors(replicates, kTwoPixels, importance);
  EXPECT_NEAR(errors.light[0], 3.0, 1e-5);
  EXPECT_NEAR(errors.variance[0], 2.25, 1e-5);  // half the variance of 1.5 and 4.5
  EXPECT_NEAR(errors.variance[1], 0.0, 1e-9);
}

TEST(WeightedErrors, VarianceOfAMeanFallsWithTheNumberOfPictures) {
  const std::vector<std::vector<float>> pictures = {{1.F}, {2.F}, {3.F}, {6.F}};
  // Squared distances from 3: 4 + 1 + 0 + 9, over n (n - 1).
  EXPECT_NEAR(variance_of_mean(pictures)[0], 14.0 / 12.0, 1e-6);
}

TEST(WeightedErrors, TrimmingDropsTheWorstThousandth) {
  std::vector<double> variance(2000);
  for (std::size_t i = 0; i < variance.size(); ++i) variance[i] = static_cast<double>(i * 7 % 2000);
  const std::vector<double> kept = trimmed(variance);
  for (std::size_t i = 0; i < variance.size(); ++i) {
    EXPECT_EQ(kept[i], variance[i] < 1998.0 ? variance[i] : 0.0);
  }
  // A small thing before nothing: what has errors at all is not the worst of many.
  std::vector<double> few(2000);
  few[7] = 3.0;
  EXPECT_EQ(trimmed(few), few);
  // Too few to have a worst thousandth.
  EXPECT_EQ(trimmed({1.0, 5.0}), (std::vector<double>{1.0, 5.0}));
}

}  // namespace
}  // namespace ajar
