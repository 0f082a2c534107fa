#include "integrator/selective/optimal_weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace ajar {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Estimates = std::vector<RegionEstimate>;

/// Regions whose variances span four powers of ten.
Estimates random_regions(std::mt19937& generator, std::size_t count) {
  std::uniform_real_distribution<double> uniform;
  Estimates regions(count);
  for (RegionEstimate& region : regions) {
    region.variance = std::pow(10.0, 4.0 * uniform(generator) - 2.0);
    region.light = 0.1 + uniform(generator);
  }
  return regions;
}

/// Smallest error of three regions on a grid of weights.
double smallest_on_grid(const Estimates& regions, const Effort& effort, int steps) {
  double best = kInfinity;
  const auto at = [&](const RegionEstimate& region, int i) {
    return region.minimum + (region.maximum - region.minimum) * i / steps;
  };
  std::vector<double> weights(3);
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      for (int k = 0; k <= steps; ++k) {
        weights = {at(regions[0], i), at(regions[1], j), at(regions[2], k)};
        best = std::min(best, predict_error(regions, effort, weights).error());
      }
    }
  }
  return best;
}

TEST(PredictError, IsTheModelByHand) {
  const Estimates regions = {{.variance = 4.0, .light = 3.0}, {.variance = 8.0, .light = 1.0}};
  const auto result = predict_error(regions, {2.0, 10.0, 5.0}, std::vector<double>{0.5, 0.0});
  EXPECT_DOUBLE_EQ(result.chain_light, 1.5);
  EXPECT_DOUBLE_EQ(result.omc_error, 0.25 * 4.0 / 2.0 + 8.0 / 2.0);
  EXPECT_DOUBLE_EQ(result.chain_error, 5.0 * 2.25 / 10.0);
}

TEST(OptimalWeights, OfOneRegionWeighTwoEstimatesByTheirVariances) {
  // V/n against C·g²/N: the closed form of two independent estimates.
  const Estimates regions = {{.variance = 6.0, .light = 2.0}};
  const Effort effort{3.0, 100.0, 25.0};
  const OptimalWeights result = optimal_weights(regions, effort);
  const double omc = 6.0 / 3.0;
  const double chains = 25.0 * 4.0 / 100.0;
  EXPECT_NEAR(result.weights[0], omc / (omc + chains), 1e-12);
  EXPECT_NEAR(result.error(), omc * chains / (omc + chains), 1e-12);
}

TEST(OptimalWeights, AreNoWorseThanTheBestOnAGrid) {
  std::mt19937 generator(1);
  for (int run = 0; run < 30; ++run) {
    Estimates regions = random_regions(generator, 3);
    if (run % 3 == 1) regions[1].minimum = 0.3;
    if (run % 3 == 2) regions[2].maximum = 0.4;
    const Effort effort{16.0, 100.0, 30.0};
    const double error = optimal_weights(regions, effort).error();
    const double best = smallest_on_grid(regions, effort, 40);
    EXPECT_LE(error, best * (1.0 + 1e-12)) << run;
    // The grid is at most 1/80 away from the minimum in each weight.
    EXPECT_GE(error, 0.9 * best) << run;
  }
}

TEST(OptimalWeights, CannotBeImprovedByAnySmallStep) {
  std::mt19937 generator(2);
  for (int run = 0; run < 20; ++run) {
    const Estimates regions = random_regions(generator, 50);
    const Effort effort{16.0, 1e4, 30.0};
    const OptimalWeights best = optimal_weights(regions, effort);
    for (std::size_t r = 0; r < regions.size(); ++r) {
      for (const double step : {-1e-3, 1e-3}) {
        std::vector<double> weights = best.weights;
        weights[r] = std::clamp(weights[r] + step, 0.0, 1.0);
        EXPECT_GE(predict_error(regions, effort, weights).error(), best.error() * (1.0 - 1e-12));
      }
    }
  }
}

TEST(OptimalWeights, SolveTheFixedPointOfBothRules) {
  std::mt19937 generator(3);
  const Estimates regions = random_regions(generator, 100);
  const Effort effort{16.0, 1e4, 30.0};
  for (const WeightRule rule : {WeightRule::Picture, WeightRule::Pixel}) {
    const OptimalWeights result = optimal_weights(regions, effort, rule);
    const double factor = rule == WeightRule::Pixel ? 2.0 : 1.0;
    for (std::size_t r = 0; r < regions.size(); ++r) {
      const double expected = 1.0 - effort.correlation * regions[r].light * result.chain_light *
                                        effort.omc_samples /
                                        (factor * effort.mutations * regions[r].variance);
      EXPECT_NEAR(result.weights[r], std::clamp(expected, 0.0, 1.0), 1e-9);
    }
  }
}

TEST(OptimalWeights, OfEachPixelAloneAreWorseForThePicture) {
  std::mt19937 generator(4);
  const Estimates regions = random_regions(generator, 100);
  const Effort effort{16.0, 1e3, 30.0};
  const OptimalWeights picture = optimal_weights(regions, effort);
  const OptimalWeights pixel = optimal_weights(regions, effort, WeightRule::Pixel);
  EXPECT_GT(pixel.error(), 1.01 * picture.error());
  EXPECT_GT(pixel.chain_light, picture.chain_light);
}

TEST(OptimalWeights, LeaveEasyPicturesToOrdinaryMonteCarlo) {
  // Where there is no variance at all, exactly.
  const Estimates still = {{.variance = 0.0, .light = 2.0}, {.variance = 0.0, .light = 0.0}};
  const OptimalWeights none = optimal_weights(still, {});
  EXPECT_EQ(none.weights, (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(none.error(), 0.0);
  // Where it is small, in proportion to it.
  const Estimates easy = {{.variance = 1e-9, .light = 1.0}, {.variance = 1e-9, .light = 1.0}};
  for (const double weight : optimal_weights(easy, {}).weights) EXPECT_LT(weight, 1e-9);
  // And beside a hard region, easy ones get nothing.
  const Estimates mixed = {{.variance = 1e-3, .light = 1.0}, {.variance = 1e3, .light = 1.0}};
  const OptimalWeights result = optimal_weights(mixed, {});
  EXPECT_EQ(result.weights[0], 0.0);
  EXPECT_GT(result.weights[1], 0.99);
}

TEST(OptimalWeights, LeaveHardPicturesToTheChains) {
  const Estimates hard = {{.variance = 1e12, .light = 1.0}, {.variance = 1e11, .light = 3.0}};
  for (const double weight : optimal_weights(hard, {}).weights) EXPECT_GT(weight, 1.0 - 1e-9);
  const Estimates hopeless = {{.variance = kInfinity, .light = 1.0},
                              {.variance = kInfinity, .light = 3.0},
                              {.variance = 1.0, .light = 1e-3}};
  const OptimalWeights result = optimal_weights(hopeless, {});
  EXPECT_EQ(result.weights[0], 1.0);
  EXPECT_EQ(result.weights[1], 1.0);
  EXPECT_TRUE(std::isfinite(result.error()));
}

TEST(OptimalWeights, KeepToTheirBounds) {
  const Estimates regions = {{.variance = 0.0, .light = 1.0, .minimum = 0.1},
                             {.variance = kInfinity, .light = 1.0, .maximum = 0.7},
                             {.variance = 1e6, .light = 1.0, .minimum = 0.3, .maximum = 0.3}};
  const OptimalWeights result = optimal_weights(regions, {});
  EXPECT_EQ(result.weights, (std::vector<double>{0.1, 0.7, 0.3}));
  EXPECT_EQ(result.omc_error, kInfinity);
}

TEST(OptimalWeights, GiveNoiseWithoutLightToTheChains) {
  EXPECT_EQ(optimal_weights(Estimates{{.variance = 1.0, .light = 0.0}}, {}).weights[0], 1.0);
}

TEST(OptimalWeights, DoNotDependOnUnits) {
  std::mt19937 generator(5);
  Estimates regions = random_regions(generator, 20);
  const OptimalWeights once = optimal_weights(regions, {16.0, 1e3, 30.0});
  for (const double unit : {1e-100, 1e100}) {
    Estimates scaled = regions;
    for (RegionEstimate& region : scaled) {
      region.variance *= unit * unit;
      region.light *= unit;
    }
    const OptimalWeights other = optimal_weights(scaled, {16.0, 1e3, 30.0});
    for (std::size_t r = 0; r < regions.size(); ++r) {
      EXPECT_NEAR(other.weights[r], once.weights[r], 1e-9);
    }
  }
}

TEST(OptimalWeights, OfNoRegionsAreNone) { EXPECT_TRUE(optimal_weights({}, {}).weights.empty()); }

TEST(OptimalWeights, RefuseWhatCannotBe) {
  const double nan = std::nan("");
  const auto refuses = [](const RegionEstimate& region, const Effort& effort = {}) {
    EXPECT_THROW(optimal_weights(Estimates{region}, effort), std::invalid_argument);
  };
  refuses({.variance = -1.0});
  refuses({.variance = nan});
  refuses({.light = -1.0});
  refuses({.light = kInfinity});
  refuses({.minimum = 0.6, .maximum = 0.5});
  refuses({.maximum = 1.5});
  refuses({}, {0.0, 1.0, 1.0});
  refuses({}, {1.0, nan, 1.0});
  refuses({}, {1.0, 1.0, -1.0});
  EXPECT_THROW(predict_error(Estimates(2), {}, std::vector<double>(3)), std::invalid_argument);
}

TEST(OptimalSplit, IsNoWorseThanAnyOtherShare) {
  std::mt19937 generator(6);
  for (int run = 0; run < 20; ++run) {
    const Estimates regions = random_regions(generator, 10);
    const RenderCosts costs{.seconds = 60.0,
                            .seconds_per_omc_sample = 0.5,
                            .seconds_per_mutation = 1e-3,
                            .correlation = 200.0,
                            .omc_only_variance = run % 2 == 0 ? 0.0 : 10.0};
    const TimeSplit split = optimal_split(regions, costs);
    double best = kInfinity;
    for (int i = 1; i < 1000; ++i) {
      const double share = i / 1000.0;
      const Effort effort{share * 60.0 / 0.5, (1.0 - share) * 60.0 / 1e-3, 200.0};
      best = std::min(best, optimal_weights(regions, effort).error() +
                                costs.omc_only_variance / effort.omc_samples);
    }
    EXPECT_LE(split.weights.error(), best * (1.0 + 1e-9)) << run;
    EXPECT_GE(split.weights.error(), best * (1.0 - 1e-2)) << run;
  }
}

TEST(OptimalSplit, OfFixedWeightsIsTheOneOfTheSquareRoots) {
  // X/f + Y/(1 − f) is smallest at √X/(√X + √Y). Here X = (0.25·16 + 5)·2 and Y = 2²·9·0.5.
  const Estimates regions = {{.variance = 16.0, .light = 4.0, .minimum = 0.5, .maximum = 0.5}};
  const TimeSplit split = optimal_split(regions, {.seconds = 1.0,
                                                  .seconds_per_omc_sample = 2.0,
                                                  .seconds_per_mutation = 0.5,
                                                  .correlation = 9.0,
                                                  .omc_only_variance = 5.0});
  EXPECT_NEAR(split.omc_share, 0.5, 1e-9);
  EXPECT_NEAR(split.effort.omc_samples, 0.25, 1e-9);
  EXPECT_NEAR(split.effort.mutations, 1.0, 1e-9);
  EXPECT_NEAR(split.weights.error(), 36.0 + 36.0, 1e-6);
}

TEST(OptimalSplit, GivesEverythingToTheHalfThatIsNeeded) {
  const RenderCosts costs{
      .seconds = 60.0, .seconds_per_omc_sample = 0.5, .seconds_per_mutation = 1e-3};
  const TimeSplit easy = optimal_split(Estimates{{.variance = 0.0, .light = 1.0}}, costs);
  EXPECT_GT(easy.omc_share, 1.0 - 1e-9);
  EXPECT_EQ(easy.weights.weights[0], 0.0);
  const TimeSplit hard = optimal_split(Estimates{{.variance = kInfinity, .light = 1.0}}, costs);
  EXPECT_LT(hard.omc_share, 1e-9);
  EXPECT_EQ(hard.weights.weights[0], 1.0);
}

TEST(OptimalSplit, RefusesWhatCannotBe) {
  const Estimates regions(1);
  EXPECT_THROW(
      optimal_split(regions,
                    {.seconds = 0.0, .seconds_per_omc_sample = 1.0, .seconds_per_mutation = 1.0}),
      std::invalid_argument);
  EXPECT_THROW(optimal_split(regions, {.seconds = 1.0, .seconds_per_omc_sample = 1.0}),
               std::invalid_argument);
}

}  // namespace
}  // namespace ajar
