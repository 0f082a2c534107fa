#include "mcmc/path_space/inverse_probability.h"

#include <gtest/gtest.h>

#include "mcmc/moments.h"

namespace ajar {
namespace {

constexpr CountingRoulette kEarlyRoulette{16, 0.25};

/// One of ten counts is up to roulette at 0.14, six of ten at 0.03.
TEST(InverseProbability, IsTheMeanOfTriesWithRouletteOrWithout) {
  for (const double probability : {1.0, 0.14, 0.05, 0.03}) {
    Moments counted;
    for (std::uint64_t i = 0; i < 1000000; ++i) {
      const auto succeeds = [&](std::uint64_t number) {
        return to_unit_double(hash_numbers(1, i, number)) < probability;
      };
      counted.add(inverse_probability(succeeds, 1.0, kEarlyRoulette, hash_numbers(2, i)));
    }
    EXPECT_NEAR(counted.mean(), 1.0 / probability, 5.0 * counted.standard_error()) << probability;
    EXPECT_LT(5.0 * counted.standard_error(), 0.1 / probability) << "too noisy to notice";
  }
}

/// Tries that count less and less are as good as those that something else may end: what it leaves
/// and what it takes are shares of 1 for any probability, and no count is beyond 1/(1 − discount).
TEST(InverseProbability, WithADiscountIsThatOfEitherOfTwo) {
  constexpr double kOther = 0.05;
  for (const double probability : {1.0, 0.14, 0.03, 0.001, 0.0}) {
    Moments counted;
    for (std::uint64_t i = 0; i < 50000; ++i) {
      const auto succeeds = [&](std::uint64_t number) {
        return to_unit_double(hash_numbers(4, i, number)) < probability;
      };
      const double count = inverse_probability(succeeds, 1.0 - kOther, {1U << 16U, 0.25}, i);
      ASSERT_LT(count, 1.0 / kOther + 1e-9);
      counted.add(count);
    }
    const double expected = 1.0 / (kOther + (1.0 - kOther) * probability);
    EXPECT_NEAR(counted.mean(), expected, 5.0 * counted.standard_error() + 1e-6 * expected);
    EXPECT_LT(5.0 * counted.standard_error(), 0.05 * expected) << "too noisy to notice";
  }
}

/// Roulette beside it changes no mean.
TEST(InverseProbability, WithADiscountAllowsRoulette) {
  constexpr double kOther = 0.02;
  constexpr double kProbability = 0.03;
  Moments counted;
  for (std::uint64_t i = 0; i < 300000; ++i) {
    const auto succeeds = [&](std::uint64_t number) {
      return to_unit_double(hash_numbers(5, i, number)) < kProbability;
    };
    counted.add(inverse_probability(succeeds, 1.0 - kOther, kEarlyRoulette, hash_numbers(6, i)));
  }
  const double expected = 1.0 / (kOther + (1.0 - kOther) * kProbability);
  EXPECT_NEAR(counted.mean(), expected, 5.0 * counted.standard_error());
  EXPECT_LT(5.0 * counted.standard_error(), 0.1 * expected) << "too noisy to notice";
}

TEST(InverseProbability, OfImpossibleEventsEndsSoonAndIsZero) {
  constexpr std::uint64_t kCounts = 10000;
  std::uint64_t all = 0;
  for (std::uint64_t i = 0; i < kCounts; ++i) {
    const auto never = [&](std::uint64_t /*number*/) {
      ++all;
      return false;
    };
    EXPECT_EQ(inverse_probability(never, 1.0, kEarlyRoulette, hash_numbers(3, i)), 0.0);
  }
  EXPECT_NEAR(static_cast<double>(all) / kCounts, 24.0, 5.0) << "16 · (1 + ¼ + 2·¼² + …)";
}

}  // namespace
}  // namespace ajar
