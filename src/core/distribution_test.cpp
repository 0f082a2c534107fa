#include "core/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"

namespace ajar {
namespace {

TEST(Distribution1D, ChoosesInProportionToWeights) {
  const std::vector<float> weights{1.F, 0.F, 3.F, 0.5F, 0.F};
  const Distribution1D distribution(weights);
  EXPECT_DOUBLE_EQ(distribution.total(), 4.5);
  std::vector<int> counts(weights.size());
  constexpr int kSamples = 200000;
  Rng rng(1);
  for (int i = 0; i < kSamples; ++i) {
    const auto choice = distribution.choose(rng.next());
    ASSERT_LT(choice.index, weights.size());
    ASSERT_GT(choice.probability, 0.F);
    ASSERT_EQ(choice.probability, distribution.probability(choice.index));
    ASSERT_GE(choice.u, 0.F);
    ASSERT_LT(choice.u, 1.F);
    ++counts[choice.index];
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double p = weights[i] / 4.5;
    EXPECT_NEAR(distribution.probability(i), p, 1e-6);
    EXPECT_NEAR(counts[i], kSamples * p, 5.0 * std::sqrt(kSamples * p) + 1e-9);
  }
}

TEST(Distribution1D, NeverChoosesZeroWeightsAtTheEndsOfTheUnitInterval) {
  const std::vector<float> weights{0.F, 0.F, 2.F, 0.F, 1.F, 0.F};
  const Distribution1D distribution(weights);
  EXPECT_EQ(distribution.choose(0.F).index, 2U);
  EXPECT_EQ(distribution.choose(kOneMinusEpsilon).index, 4U);
  EXPECT_EQ(distribution.choose(1.F).index, 4U);
  EXPECT_LT(distribution.choose(1.F).u, 1.F);
}

TEST(Distribution1D, GuidesLeadToTheCellOfALinearSearch) {
  Rng rng(4);
  for (const std::size_t n : {1U, 2U, 3U, 7U, 100U, 1000U}) {
    std::vector<float> weights;
    for (std::size_t i = 0; i < n; ++i) {
      weights.push_back(rng.next() < 0.4F ? 0.F : std::exp(30.F * rng.next()));
    }
    weights[n / 2] = 1.F;
    const Distribution1D distribution(weights);
    for (int i = 0; i < 20000; ++i) {
      // Also the borders between guides, and the numbers next to them.
      float u = rng.next();
      if (i % 2 == 0) {
        u = std::floor(u * static_cast<float>(n)) / static_cast<float>(n);
        if (i % 4 == 0) u = std::nextafter(u, 0.F);
      }
      std::size_t cell = 0;
      float end = distribution.probability(0);
      double sum = end;
      while (u >= end && cell + 1 < n) {
        ++cell;
        sum += distribution.probability(cell);
        end = static_cast<float>(sum);
      }
      while (distribution.probability(cell) == 0.F) --cell;
      ASSERT_EQ(distribution.choose(u).index, cell) << "u = " << u << ", n = " << n;
    }
  }
}

TEST(Distribution1D, StretchesTheUniformNumber) {
  const Distribution1D distribution(std::vector<float>{1.F, 1.F, 2.F});
  EXPECT_FLOAT_EQ(distribution.choose(0.125F).u, 0.5F);
  EXPECT_FLOAT_EQ(distribution.choose(0.75F).u, 0.5F);
}

TEST(Distribution1D, AllZeroIsUniform) {
  const Distribution1D distribution(std::vector<float>(5, 0.F));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(distribution.probability(i), 0.2F, 1e-6F);
  EXPECT_EQ(distribution.total(), 0.0);
}

TEST(Distribution1D, CanChooseEveryPositiveWeight) {
  std::vector<float> weights(4096, 1e-12F);
  weights[7] = 1e12F;
  weights[4000] = 0.F;
  const Distribution1D distribution(weights);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (i == 4000) {
      EXPECT_EQ(distribution.probability(i), 0.F);
    } else {
      EXPECT_GT(distribution.probability(i), 0.F) << i;
    }
    sum += distribution.probability(i);
  }
  EXPECT_NEAR(sum, 1.0, 1e-6);
  EXPECT_GT(distribution.probability(7), 0.99F);
}

TEST(Distribution2D, PdfOfASampleIsItsOwn) {
  // Odd sizes and strong contrast: rounding must not carry samples into the next cell.
  constexpr int kWidth = 1237;
  constexpr int kHeight = 611;
  std::vector<float> weights;
  weights.reserve(std::size_t{kWidth} * kHeight);
  Rng rng(2);
  for (int i = 0; i < kWidth * kHeight; ++i) weights.push_back(std::exp(20.F * rng.next()));
  const Distribution2D distribution(weights, kWidth, kHeight);
  for (int i = 0; i < 500000; ++i) {
    const float x = rng.next();
    const auto sample = distribution.sample({x, rng.next()});
    ASSERT_GT(sample.pdf, 0.F);
    ASSERT_EQ(distribution.pdf(sample.uv), sample.pdf);
    ASSERT_LT(sample.uv.x, 1.F);
    ASSERT_LT(sample.uv.y, 1.F);
  }
}

TEST(Distribution2D, SamplesInProportionToWeights) {
  const std::vector<float> weights{1, 2, 0, 4, 0, 0, 0, 0, 3, 1, 5, 2};
  const Distribution2D distribution(weights, 4, 3);
  std::vector<int> counts(12);
  Rng rng(3);
  constexpr int kSamples = 200000;
  for (int i = 0; i < kSamples; ++i) {
    const float x = rng.next();
    const auto sample = distribution.sample({x, rng.next()});
    ++counts[static_cast<std::size_t>(sample.uv.y * 3.F) * 4 +
             static_cast<std::size_t>(sample.uv.x * 4.F)];
  }
  for (std::size_t i = 0; i < 12; ++i) {
    const double p = weights[i] / 18.0;
    EXPECT_NEAR(counts[i], kSamples * p, 5.0 * std::sqrt(kSamples * p) + 1e-9);
    const std::size_t column = i % 4;
    const std::size_t row = i / 4;
    EXPECT_NEAR(distribution.pdf({(static_cast<float>(column) + 0.5F) / 4.F,
                                  (static_cast<float>(row) + 0.5F) / 3.F}),
                p * 12.0, 1e-4);
  }
}

TEST(Distribution2D, RefusesWeightsThatDoNotFit) {
  EXPECT_THROW(Distribution2D(std::vector<float>(5), 2, 3), std::invalid_argument);
  EXPECT_THROW(Distribution2D(std::vector<float>{}, 0, 0), std::invalid_argument);
}

TEST(Distribution1D, InverseGivesTheCell) {
  // Also cells that are as wide as uniform numbers are apart.
  std::vector<float> weights(3000, 1e-9F);
  weights[5] = 1.F;
  weights[6] = 0.F;
  weights[1777] = 3.F;
  const Distribution1D distribution(weights);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == 0.F) continue;
    for (const float u : {0.F, 0.3F, kOneMinusEpsilon}) {
      ASSERT_EQ(distribution.choose(distribution.invert(i, u)).index, i) << u;
    }
  }
  EXPECT_NEAR(distribution.choose(distribution.invert(1777, 0.3F)).u, 0.3F, 1e-6F);
}

TEST(Distribution2D, InverseGivesThePlace) {
  const std::vector<float> weights{0.F, 1.F, 5.F, 2.F, 0.F, 0.F, 0.F, 7.F, 1e-3F};
  const Distribution2D grid(weights, 3, 3);
  Rng rng(7);
  for (int i = 0; i < 20000; ++i) {
    const float x = rng.next();
    const auto sample = grid.sample({x, rng.next()});
    const auto again = grid.sample(grid.invert(sample.uv));
    EXPECT_EQ(again.pdf, sample.pdf);
    // The smallest cell is a few thousandths of the numbers.
    EXPECT_LT((again.uv - sample.uv).length(), 1e-4F);
  }
}

}  // namespace
}  // namespace ajar
