#include "image/visible_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace ajar {
namespace {

constexpr double kLowest = 1e-3;
constexpr double kHighest = 1e4;
/// Ratios are √2 apart.
constexpr double kNear = 1.2;

double best_ratio(const std::vector<double>& omc, const std::vector<double>& chains,
                  double sample_cost = 1.0, double mutation_cost = 1.0) {
  return mutations_of_least_visible_error(omc, chains, sample_cost, mutation_cost, kLowest,
                                          kHighest);
}

TEST(VisibleError, OfOnePixelIsThatOfTheBestSplitOfTime) {
  // It is smallest where V/n + M/N is: N/n = √(M·c_s / (V·c_m)).
  for (const double chains : {1e-2, 1.0, 50.0}) {
    for (const double cost : {0.1, 3.0}) {
      const double exact = std::sqrt(chains / (4.0 * cost));
      const double found = best_ratio({4.0}, {chains}, 1.0, cost);
      EXPECT_LT(found, exact * kNear);
      EXPECT_GT(found, exact / kNear);
    }
  }
}

TEST(VisibleError, IsNotDecidedByTheWorstPixel) {
  // 99 pixels have noise of OMC alone, in one the chains are far off.
  std::vector<double> omc(100, 1.0);
  std::vector<double> chains(100, 0.0);
  chains.back() = 1e4;
  const double of_squares = std::sqrt(1e4 / 100.0);
  const double found = best_ratio(omc, chains);
  EXPECT_LT(found, of_squares / 4.0);
  double least = std::numeric_limits<double>::infinity();
  double best = 0.0;
  for (int i = 0; i < 1600; ++i) {
    const double ratio = kLowest * std::pow(1.01, i);
    const double error = (99.0 + std::pow(1.0 + 1e4 / ratio, 0.35)) * std::pow(1.0 + ratio, 0.35);
    if (error < least) {
      least = error;
      best = ratio;
    }
  }
  EXPECT_LT(found, best * kNear);
  EXPECT_GT(found, best / kNear);
}

TEST(VisibleError, OfTwoPartsIsLeastWithTheSamplesTheyDeserve) {
  // The first has a third of the pixels.
  const double first = 1.0;
  const double second = 9.0;
  const auto error = [&](double of_first) {
    const double of_second = (1.0 - of_first / 3.0) * 1.5;
    return visible_error(first / of_first) + 2.0 * visible_error(second / of_second);
  };
  const double ratio = samples_for(visible_error(first)) / samples_for(visible_error(second));
  const double deserved = 3.0 * ratio / (ratio + 2.0);
  for (const double other : {0.9, 1.1}) EXPECT_LT(error(deserved), error(deserved * other));
}

TEST(VisibleError, StaysWithinItsBounds) {
  EXPECT_EQ(best_ratio({1.0, 1.0}, {0.0, 0.0}), kLowest);
  EXPECT_GT(best_ratio({0.0, 0.0}, {1.0, 1.0}), kHighest / 2.0);
  EXPECT_LE(best_ratio({0.0, 0.0}, {1.0, 1.0}), kHighest);
}

TEST(VisibleError, RefusesWhatMakesNoSense) {
  const std::vector<double> one = {1.0};
  const std::vector<double> two = {1.0, 1.0};
  EXPECT_THROW(best_ratio(one, two), std::invalid_argument);
  EXPECT_THROW(best_ratio(one, one, 0.0), std::invalid_argument);
  EXPECT_THROW(best_ratio(one, one, 1.0, std::nan("")), std::invalid_argument);
  EXPECT_THROW(mutations_of_least_visible_error(one, one, 1.0, 1.0, 2.0, 1.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace ajar
