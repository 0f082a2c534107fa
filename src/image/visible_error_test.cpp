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
                  double usual = 1.0, double sample_cost = 1.0, double mutation_cost = 1.0) {
  return mutations_of_least_visible_error(omc, chains, usual, sample_cost, mutation_cost, kLowest,
                                          kHighest);
}

/// By looking everywhere. `pixels`: how many there are of each kind.
double slowly_found_ratio(const std::vector<double>& pixels, const std::vector<double>& omc,
                          const std::vector<double>& chains, double usual, double sample_cost,
                          double mutation_cost) {
  double least = std::numeric_limits<double>::infinity();
  double best = 0.0;
  for (int i = 0; i < 1600; ++i) {
    const double ratio = kLowest * std::pow(1.01, i);
    double error = 0.0;
    for (std::size_t j = 0; j < pixels.size(); ++j) {
      const double variance = omc[j] + chains[j] * usual / ratio;
      error += pixels[j] * std::pow(variance, 0.35);
    }
    error *= std::pow(sample_cost + ratio * mutation_cost, 0.35);
    if (error >= least) continue;
    least = error;
    best = ratio;
  }
  return best;
}

void expect_near(double found, double exact) {
  EXPECT_LT(found, exact * kNear);
  EXPECT_GT(found, exact / kNear);
}

TEST(VisibleError, OfOnePixelIsThatOfTheBestSplitOfTime) {
  // (c_s + N · c_m) · (V + K · u/N) is smallest there, whatever the error is.
  for (const double chains : {1e-2, 1.0, 50.0}) {
    for (const double usual : {0.2, 5.0}) {
      const double found = best_ratio({4.0}, {chains}, usual, 1.0, 0.3);
      expect_near(found, std::sqrt(chains * usual / (4.0 * 0.3)));
      expect_near(found, slowly_found_ratio({1.0}, {4.0}, {chains}, usual, 1.0, 0.3));
    }
  }
}

TEST(VisibleError, IsNotDecidedByTheWorstPixel) {
  // 99 pixels have noise of OMC alone, in one the chains are far off.
  std::vector<double> omc(100, 1.0);
  std::vector<double> chains(100, 0.0);
  chains.back() = 1e4;
  const double found = best_ratio(omc, chains);
  const double of_squares = std::sqrt(1e4 / 100.0);
  EXPECT_LT(found, of_squares / 4.0);
  expect_near(found, slowly_found_ratio({99.0, 1.0}, {1.0, 1.0}, {0.0, 1e4}, 1.0, 1.0, 1.0));
}

TEST(VisibleError, StaysWithinItsBounds) {
  EXPECT_EQ(best_ratio({1.0, 1.0}, {0.0, 0.0}), kLowest);
  EXPECT_GT(best_ratio({0.0, 0.0}, {1.0, 1.0}, 1.0, 1e18), kHighest / 2.0);
  EXPECT_LE(best_ratio({0.0, 0.0}, {1.0, 1.0}, 1.0, 1e18), kHighest);
}

TEST(VisibleError, RefusesInvalidInput) {
  const std::vector<double> one = {1.0};
  const std::vector<double> two = {1.0, 1.0};
  EXPECT_THROW(best_ratio(one, two), std::invalid_argument);
  EXPECT_THROW(best_ratio(one, one, 0.0), std::invalid_argument);
  EXPECT_THROW(best_ratio(one, one, 1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(best_ratio(one, one, 1.0, 1.0, std::nan("")), std::invalid_argument);
  EXPECT_THROW(mutations_of_least_visible_error(one, one, 1.0, 1.0, 1.0, 2.0, 1.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace ajar
