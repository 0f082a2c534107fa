#include "support/mean_over_seeds.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/random.h"

namespace ajar {
namespace {

/// Uniform numbers around a mean, with a standard deviation of a tenth.
class Values {
 public:
  explicit Values(double mean) : mean_(mean) {}
  double operator()(std::uint64_t seed) {
    ++count;
    const auto bits = static_cast<std::uint32_t>(hash_numbers(3, seed) >> 32U);
    return mean_ + std::sqrt(0.12) * (static_cast<double>(to_unit_float(bits)) - 0.5);
  }
  int count = 0;

 private:
  double mean_;
};

/// With 99 seeds, five errors of the mean are half of the effect.
constexpr test::ExpectedMean kOne{1.0, 0.0, 0.1};
constexpr int kSeeds = 99;

TEST(MeanOverSeeds, IsKnownAfterAThirdOfThemIfItIsRight) {
  Values right(1.0);
  test::expect_mean_over_seeds(kOne, kSeeds, std::ref(right), "right");
  EXPECT_EQ(right.count, kSeeds / 3);
}

TEST(MeanOverSeeds, IsNoticedIfItIsWrong) {
  for (const double mean : {0.86, 0.9, 1.1, 1.14}) {
    Values wrong(mean);
    EXPECT_NONFATAL_FAILURE(test::expect_mean_over_seeds(kOne, kSeeds, std::ref(wrong), "wrong"),
                            "wrong");
    EXPECT_EQ(wrong.count, kSeeds);
  }
}

TEST(MeanOverSeeds, IsNoClaimIfItIsTooNoisy) {
  Values right(1.0);
  EXPECT_NONFATAL_FAILURE(
      test::expect_mean_over_seeds({1.0, 0.0, 0.01}, kSeeds, std::ref(right), "noise"),
      "too noisy");
}

}  // namespace
}  // namespace ajar
