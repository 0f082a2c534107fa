#include "integrator/selective/optimal_thresholds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace ajar {
namespace {

/// Three regions: one whose bright light is rare, one where all light is bright, one without any.
std::vector<ThresholdEstimate> three_regions() {
  return {{{1.0, 3.0, 900.0}, {2.0, 1.9, 0.0}},
          {{4.0, 5.0, 6.0}, {30.0, 10.0, 0.0}},
          {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}};
}

TEST(OptimalThresholds, AreNoWorseThanAnyOthers) {
  const auto regions = three_regions();
  for (const double correlation : {0.01, 1.0, 30.0, 3000.0}) {
    for (const double base : {0.0, 10.0, 1e4}) {
      const ThresholdCosts costs{3.0, 0.2, correlation, base};
      const ThresholdChoice best = optimal_thresholds(regions, costs);
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
          least = std::min(least, predict_thresholds(regions, costs, {a, b, 0}).error);
        }
      }
      EXPECT_NEAR(best.error, least, 1e-9 * least) << correlation << ", " << base;
      EXPECT_EQ(best.chosen[2], 0U) << "without evidence, chains stay ready";
    }
  }
}

TEST(OptimalThresholds, LeaveChainsOutIfTheyAreTooNoisyAndGiveThemMuchIfTheyAreNot) {
  const auto regions = three_regions();
  const ThresholdChoice none = optimal_thresholds(regions, {1.0, 1.0, 1e9, 0.0});
  EXPECT_EQ(none.chain_light, 0.0);
  const ThresholdChoice all = optimal_thresholds(regions, {1.0, 1.0, 1e-9, 0.0});
  EXPECT_EQ(all.chain_light, 32.0);
}

TEST(OptimalThresholds, AreFoundBetweenTheEndsOfOneRegion) {
  // Neither end's price of variance leads to the third threshold.
  const std::vector<ThresholdEstimate> region = {
      {{6.9, 18.8, 53.1, 117.8, 215.6}, {1718.0, 1424.0, 997.7, 597.9, 271.4}}};
  const ThresholdCosts costs{15.1 * 27648.0, 4.35, 5.69, 0.0};
  EXPECT_EQ(optimal_thresholds(region, costs).chosen, std::vector<std::size_t>{2});
}

TEST(OptimalThresholds, PredictTheErrorOfTheBestSplitOfTime) {
  const auto regions = three_regions();
  const ThresholdCosts costs{3.0, 0.2, 5.0, 2.0};
  const ThresholdChoice choice = predict_thresholds(regions, costs, {0, 1, 0});
  EXPECT_DOUBLE_EQ(choice.variance, 8.0);
  EXPECT_DOUBLE_EQ(choice.chain_light, 12.0);
  // Among splits f of one unit of time, X·c_s/f + C·b²·c_m/(1 − f) is smallest where n and N are.
  const auto error = [&](double f) {
    return choice.variance * costs.omc_sample / f +
           costs.correlation * 144.0 * costs.mutation / (1.0 - f);
  };
  const double ratio = best_mutations(choice.variance, choice.chain_light, costs);
  const double f = 1.0 / (1.0 + ratio * costs.mutation / costs.omc_sample);
  EXPECT_NEAR(error(f), choice.error, 1e-9 * choice.error);
  EXPECT_GT(error(0.99 * f), choice.error);
  EXPECT_GT(error(1.01 * f), choice.error);
}

TEST(OptimalThresholds, RefuseWhatIsNotAnEstimate) {
  const std::vector<ThresholdEstimate> uneven{{{1.0}, {1.0}}, {{1.0, 2.0}, {1.0, 0.0}}};
  EXPECT_THROW(optimal_thresholds(uneven, {}), std::invalid_argument);
  EXPECT_THROW(optimal_thresholds(three_regions(), {0.0, 1.0, 1.0, 0.0}), std::invalid_argument);
  EXPECT_EQ(optimal_thresholds({}, {1.0, 1.0, 1.0, 4.0}).error, 4.0);
  EXPECT_EQ(best_mutations(0.0, 1.0, {}), 0.0);
}

}  // namespace
}  // namespace ajar
