#include "image/compare_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

namespace ajar {
namespace {

/// Not a multiple of the block in either direction: 4 × 3 blocks.
constexpr BlockGrid kBlocks{60, 40, 3, 16};
constexpr std::size_t kValues = 60 * 40 * 3;

std::vector<float> picture() {
  std::vector<float> image(kValues);
  for (std::size_t i = 0; i < kValues; ++i)
    image[i] = 1.F + 0.5F * std::sin(0.02F * static_cast<float>(i));
  return image;
}

/// `noise`: relative standard deviation of one value in one replicate. Skewed (gamma distributed),
/// as renders are.
Replicates render(const std::vector<float>& truth, double noise, int count, unsigned seed) {
  std::mt19937 generator(seed);
  const double shape = 1.0 / (noise * noise);
  std::gamma_distribution<double> gamma(shape, 1.0 / shape);
  Replicates replicates(static_cast<std::size_t>(count), truth);
  for (auto& image : replicates) {
    for (float& v : image) v = static_cast<float>(v * gamma(generator));
  }
  return replicates;
}

TEST(NormalFromT, MatchesTables) {
  // 97.5 % quantiles of Student's distribution: 12.7062 (1), 2.22814 (10); of the normal: 1.95996.
  EXPECT_NEAR(normal_from_t(12.7062, 1.0), 1.95996, 1e-4);
  EXPECT_NEAR(normal_from_t(-2.22814, 10.0), -1.95996, 1e-4);
  EXPECT_EQ(normal_from_t(3.0, HUGE_VAL), 3.0);
  EXPECT_EQ(normal_from_t(0.0, 3.0), 0.0);
  EXPECT_EQ(normal_from_t(1e300, 50.0), 37.0);
  EXPECT_EQ(normal_from_t(-HUGE_VAL, 5.0), -37.0);
}

TEST(CompareBlocks, EqualImagesPassAtTheStatedRate) {
  // The family-wise p-value must be uniform or larger: count how often it falls below 0.1.
  const std::vector<float> truth = picture();
  int below = 0;
  constexpr int kTrials = 300;
  for (unsigned trial = 0; trial < kTrials; ++trial) {
    const auto result = compare_blocks(render(truth, 0.5, 6, 2 * trial),
                                       render(truth, 0.5, 6, 2 * trial + 1), kBlocks);
    EXPECT_EQ(result.tests, 4 * 3 * 3);
    EXPECT_TRUE(result.equal()) << trial;
    below += result.family_p < 0.1 ? 1 : 0;
  }
  // Binomial(300, 0.1): mean 30, σ 5.2. Welch's test is a little conservative.
  EXPECT_LT(below, 30 + 5 * 5.2);
  EXPECT_GT(below, 5);
}

TEST(CompareBlocks, FindsOnePercentInTheWholeImage) {
  // Power: noise of the difference of the means is 0.5·√(2/(16·7200)) = 0.21 %, so 1 % is 4.8 σ;
  // all of 20 trials must pass z > 2 (probability of a miss 0.3 % each), and their mean z is
  // near 4.8.
  const std::vector<float> truth = picture();
  std::vector<float> bright = truth;
  for (float& v : bright) v *= 1.01F;
  double sum = 0.0;
  for (unsigned trial = 0; trial < 20; ++trial) {
    const auto result = compare_blocks(render(bright, 0.5, 16, 1000 + trial),
                                       render(truth, 0.5, 16, 2000 + trial), kBlocks);
    EXPECT_GT(result.mean_z, 1.5);
    EXPECT_NEAR(result.mean_relative_difference, 0.01, 5 * 0.0021);
    sum += result.mean_z / 20;
  }
  EXPECT_NEAR(sum, 4.3, 1.2);
}

TEST(CompareBlocks, FindsAWrongBlockAndSaysWhere) {
  // 5 % in one channel of one block of 256 pixels, 16 replicates of 20 % noise: 11 σ before t → z.
  const std::vector<float> truth = picture();
  std::vector<float> wrong = truth;
  for (std::size_t y = 16; y < 32; ++y) {
    for (std::size_t x = 32; x < 48; ++x) wrong[(y * 60 + x) * 3 + 1] *= 1.05F;
  }
  const auto result = compare_blocks(render(wrong, 0.2, 16, 5), render(truth, 0.2, 16, 6), kBlocks);
  EXPECT_FALSE(result.equal());
  EXPECT_EQ(result.worst_block, Box2i({32, 16}, {47, 31}));
  EXPECT_EQ(result.worst_channel, 1);
  EXPECT_GT(result.worst_z, 6.0);
  EXPECT_LT(result.family_p, 1e-7);
  EXPECT_LT(std::abs(result.mean_z), 4.0) << "the whole image hides it";
}

TEST(CompareBlocks, CorrelatedPixelsAreNotIndependentEvidence) {
  // Each replicate's error is one number for all pixels, as with a chain's b.
  const std::vector<float> truth = picture();
  const auto correlated = [&](unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<float> normal(1.F, 0.1F);
    Replicates replicates(8, truth);
    for (auto& image : replicates) {
      const float factor = normal(generator);
      for (float& v : image) v *= factor;
    }
    return replicates;
  };
  for (unsigned trial = 0; trial < 100; ++trial) {
    EXPECT_TRUE(compare_blocks(correlated(trial), correlated(trial + 500), kBlocks).equal())
        << trial;
  }
}

TEST(CompareBlocks, BlocksWithoutNoiseMustAgreeButForRounding) {
  const std::vector<float> truth = picture();
  std::vector<float> rounded = truth;
  for (float& v : rounded) v = std::nextafter(v, 10.F);
  EXPECT_TRUE(compare_blocks(Replicates(4, truth), Replicates(4, rounded), kBlocks).equal());
  std::vector<float> wrong = truth;
  for (float& v : wrong) v *= 1.0001F;
  EXPECT_FALSE(compare_blocks(Replicates(4, truth), Replicates(4, wrong), kBlocks).equal());
  const std::vector<float> black(kValues);
  EXPECT_TRUE(compare_blocks(Replicates(4, black), Replicates(4, black), kBlocks).equal());
  EXPECT_FALSE(compare_blocks(Replicates(4, black), Replicates(4, truth), kBlocks).equal());
}

TEST(CompareBlocks, NanIsADifference) {
  const std::vector<float> truth = picture();
  Replicates broken = render(truth, 0.1, 4, 1);
  broken[3][100] = std::nanf("");
  EXPECT_FALSE(compare_blocks(broken, render(truth, 0.1, 4, 2), kBlocks).equal());
}

TEST(CompareBlocksToReference, CountsTheNoiseOfTheReference) {
  // The reference is one image with 30 % noise per value: without its variance, blocks would fail.
  const std::vector<float> truth = picture();
  const std::vector<float> reference = render(truth, 0.3, 1, 77)[0];
  std::vector<float> variance = truth;
  for (float& v : variance) v *= 0.09F * v;
  const Replicates image = render(truth, 0.3, 64, 78);
  EXPECT_TRUE(compare_blocks_to_reference(image, reference, variance, kBlocks).equal());
  EXPECT_FALSE(compare_blocks_to_reference(image, reference, {}, kBlocks).equal(1e-3));
  EXPECT_TRUE(compare_blocks_to_reference(image, truth, {}, kBlocks).equal());
}

TEST(CompareBlocksToReference, FindsOnePercentWithEnoughReplicates) {
  // 0.3/√(64·7200) = 0.044 %: 1 % is 22 σ, of which t(63) → z leaves more than 10.
  const std::vector<float> truth = picture();
  std::vector<float> dark = truth;
  for (float& v : dark) v *= 0.99F;
  const auto result = compare_blocks_to_reference(render(dark, 0.3, 64, 5), truth, {}, kBlocks);
  EXPECT_LT(result.mean_z, -10.0);
  EXPECT_FALSE(result.equal());
}

TEST(CompareBlocksByVariance, KeepsItsRateAndFindsAWrongBlock) {
  // Each image is the mean of 4 replicates of 30 %, with the variance that these give.
  const std::vector<float> truth = picture();
  const auto rendered = [&](const std::vector<float>& mean, unsigned seed) {
    const Replicates replicates = render(mean, 0.3, 4, seed);
    std::pair image(replicate_mean(replicates), standard_error(replicates));
    for (float& v : image.second) v *= v;
    return image;
  };
  int below = 0;
  for (unsigned trial = 0; trial < 100; ++trial) {
    const auto a = rendered(truth, 2 * trial);
    const auto b = rendered(truth, 2 * trial + 1);
    const auto result = compare_blocks_by_variance(a.first, a.second, b.first, b.second, kBlocks);
    below += result.family_p < 0.1 ? 1 : 0;
  }
  // Binomial(100, 0.1): mean 10, σ 3; small variances go with small values, which costs a little.
  EXPECT_LT(below, 10 + 6 * 3);
  // 10 % in one block of 256 pixels: the error of its difference is 0.15·√(2/256) = 1.3 %: 7.5 σ.
  std::vector<float> wrong = truth;
  for (std::size_t y = 16; y < 32; ++y) {
    for (std::size_t x = 32; x < 48; ++x) wrong[(y * 60 + x) * 3 + 1] *= 1.1F;
  }
  const auto a = rendered(wrong, 500);
  const auto b = rendered(truth, 501);
  const auto result = compare_blocks_by_variance(a.first, a.second, b.first, b.second, kBlocks);
  EXPECT_FALSE(result.equal(1e-3));
  EXPECT_EQ(result.worst_block, Box2i({32, 16}, {47, 31}));
  EXPECT_NEAR(result.typical_error, 0.013, 0.006);
  // Channels count as correlated: 2400 pixels, not 7200 values.
  EXPECT_NEAR(result.mean_error, 0.15 * std::sqrt(2.0 / 2400), 0.001);
  EXPECT_FALSE(compare_blocks_by_variance(a.first, a.second, truth, {}, kBlocks).equal(1e-3));
}

TEST(DetectableDifference, MatchesTables) {
  // Normal: 1.95996 + 1.28155; Student with 10 degrees of freedom: 2.22814 + 1.37218.
  EXPECT_NEAR(detectable_difference(2.0, HUGE_VAL, 0.05, 0.9), 2 * 3.24151, 1e-4);
  EXPECT_NEAR(detectable_difference(1.0, 10.0, 0.05, 0.9), 3.60032, 1e-4);
}

TEST(CompareBlocks, RefusesImagesThatDoNotFit) {
  const std::vector<float> truth = picture();
  EXPECT_THROW(compare_blocks({truth}, {truth, truth}, kBlocks), std::invalid_argument);
  EXPECT_THROW(compare_blocks({truth, truth}, {truth, {1.F}}, kBlocks), std::invalid_argument);
}

}  // namespace
}  // namespace ajar
