#include "post/denoise/mix_estimates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "image/blur.h"

namespace ajar {
namespace {

constexpr Vec2i kMixedSize{96, 96};
constexpr std::size_t kMixedValues = std::size_t{3} * 96 * 96;

/// Four pictures of `truth` with relative noise.
Replicates noisy(const std::vector<float>& truth, float noise) {
  std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same test each time
  std::normal_distribution<float> normal;
  Replicates replicates(4, truth);
  for (std::vector<float>& picture : replicates) {
    for (float& value : picture) value *= 1.F + noise * normal(random);
  }
  return replicates;
}

/// A filter, and none.
std::vector<BiasedEstimate> smooth_and_raw(const Replicates& replicates) {
  const std::vector<float> mean = replicate_mean(replicates);
  BiasedEstimate smooth{blurred(mean, kMixedSize, 4.0), {}};
  for (const auto& picture : replicates) smooth.parts.push_back(blurred(picture, kMixedSize, 4.0));
  return {std::move(smooth), {mean, replicates, {}, false}};
}

MixedEstimate mixture_of(const std::vector<float>& truth, float noise) {
  const Replicates replicates = noisy(truth, noise);
  return mix_estimates(kMixedSize, smooth_and_raw(replicates), replicates);
}

double mean_of(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += double{value};
  return sum / static_cast<double>(values.size());
}

double error_of(const std::vector<float>& picture, const std::vector<float>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    sum += std::pow(double{picture[i]} - double{truth[i]}, 2);
  }
  return std::sqrt(sum / static_cast<double>(picture.size()));
}

/// Stripes of two pixels: a blur of four takes all of them away.
std::vector<float> stripes() {
  std::vector<float> truth(kMixedValues);
  for (std::size_t i = 0; i < kMixedValues; ++i) truth[i] = i / 3 % 4 < 2 ? 1.5F : 0.5F;
  return truth;
}

TEST(MixEstimates, PrefersTheFilterWhereItIsUnbiased) {
  const std::vector<float> truth(kMixedValues, 0.7F);
  const MixedEstimate mixed = mixture_of(truth, 0.5F);
  EXPECT_GT(mean_of(mixed.shares[0]), 0.9);
  EXPECT_LT(error_of(mixed.pixels, truth), 0.035) << "the mean has 0.175";
}

TEST(MixEstimates, PrefersTheUnfilteredPictureWhereTheFilterIsBiased) {
  const MixedEstimate mixed = mixture_of(stripes(), 0.1F);
  EXPECT_GT(mean_of(mixed.shares[1]), 0.9);
  EXPECT_LT(error_of(mixed.pixels, stripes()), 0.1) << "the filter makes 0.5 of it";
}

/// Filters do better the less noise they see. If the bias of a replicate were that of the whole,
/// both would have equal weights here, and noise would stay in the picture.
TEST(MixEstimates, AssumesThatTheMeanIsFilteredBetterThanAReplicate) {
  const std::vector<float> truth(kMixedValues, 1.F);
  const Replicates replicates = noisy(truth, 0.6F);
  const std::vector<float> mean = replicate_mean(replicates);
  const BiasedEstimate smooth{std::vector<float>(kMixedValues, 1.15F),
                              Replicates(4, std::vector<float>(kMixedValues, 1.3F))};
  const MixedEstimate mixed =
      mix_estimates(kMixedSize, {smooth, {mean, replicates, {}, false}}, replicates);
  EXPECT_LT(mean_of(mixed.shares[1]), 0.25);
}

/// Light that a quarter of the samples has not found, all of them need not have found either.
TEST(MixEstimates, WeighsDownEstimatesThatMissLight) {
  const Replicates replicates = noisy(std::vector<float>(kMixedValues, 1.F), 0.3F);
  const BiasedEstimate noise{replicate_mean(replicates), replicates};
  BiasedEstimate dark{std::vector<float>(kMixedValues, 0.8F),
                      Replicates(4, std::vector<float>(kMixedValues, 0.8F))};
  EXPECT_GT(mean_of(mix_estimates(kMixedSize, {dark, noise}, replicates).shares[0]), 0.75);
  // Not if it is the filter's fault.
  dark.found = replicates;
  EXPECT_GT(mean_of(mix_estimates(kMixedSize, {dark, noise}, replicates).shares[0]), 0.75);
  dark.found = dark.parts;
  EXPECT_LT(mean_of(mix_estimates(kMixedSize, {dark, noise}, replicates).shares[0]), 0.45);
}

/// Condition for a consistent mixture with the unfiltered picture: with less noise the weight of a
/// biased filter falls faster than the variance.
TEST(MixEstimates, LosesBiasAsNoiseFalls) {
  const double some = mean_of(mixture_of(stripes(), 0.4F).shares[0]);
  const double less = mean_of(mixture_of(stripes(), 0.1F).shares[0]);
  const double least = mean_of(mixture_of(stripes(), 0.025F).shares[0]);
  EXPECT_LT(less, some / 16);
  EXPECT_LT(least, less / 16);
}

TEST(MixEstimates, ChoosesByPatch) {
  // The one is too bright by half on the left, the other on the right.
  const std::vector<float> truth(kMixedValues, 1.F);
  const Replicates replicates = noisy(truth, 0.3F);
  std::vector<BiasedEstimate> estimates(2, {truth, Replicates(4, truth)});
  for (std::size_t i = 0; i < kMixedValues; ++i) {
    BiasedEstimate& wrong = estimates[i / 3 % 96 < 48 ? 0 : 1];
    wrong.pixels[i] = 1.5F;
    for (std::vector<float>& picture : wrong.parts) picture[i] = 1.5F;
  }
  const MixedEstimate mixed = mix_estimates(kMixedSize, estimates, replicates);
  for (std::size_t i = 0; i < kMixedValues; ++i) {
    const std::size_t x = i / 3 % 96;
    if (x > 36 && x < 60) continue;
    ASSERT_NEAR(mixed.pixels[i], 1.F, 0.1F) << "at column " << x;
  }
}

TEST(MixEstimates, EstimatesItsOwnError) {
  for (const float noise : {0.1F, 0.4F}) {
    const MixedEstimate mixed = mixture_of(stripes(), noise);
    const double said = error_of(mixed.error, std::vector<float>(kMixedValues, 0.F));
    // A bound: errors of the two parts cancel in part.
    const double real = error_of(mixed.pixels, stripes());
    EXPECT_GT(said, 0.9 * real) << noise;
    EXPECT_LT(said, 1.6 * real) << noise;
  }
}

/// The squared bias is estimated without bias: of a filter that is right it is nothing on average,
/// so that no more than the spread of the filtered replicates is said.
TEST(MixEstimates, ReportsNoBiasOfAnUnbiasedFilter) {
  const std::vector<float> truth(kMixedValues, 1.F);
  const Replicates replicates = noisy(truth, 0.5F);
  const MixedEstimate mixed =
      mix_estimates(kMixedSize, {{truth, Replicates(4, truth)}}, replicates);
  // 0.25 for each of the products' factors over the square root of the pixels in a patch (100 of 3
  // values) and of the six pairs, which hang together; half of it is negative.
  EXPECT_LT(error_of(mixed.error, std::vector<float>(kMixedValues, 0.F)), 0.1);
}

/// Samples of path tracing are mostly black, and now and then bright. Relative to a picture that
/// has them in it, the black ones would count more.
TEST(MixEstimates, TakesSkewedNoiseForNoBias) {
  const std::vector<float> truth(kMixedValues, 1.F);
  Replicates replicates(4, truth);
  std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same test each time
  for (std::vector<float>& picture : replicates) {
    for (float& value : picture) value = random() % 4 == 0 ? 4.F : 0.F;
  }
  const MixedEstimate mixed = mix_estimates(
      kMixedSize,
      {{truth, Replicates(2, truth)}, {replicate_mean(replicates), replicates, {}, false}},
      replicates);
  // 1.5 is the variance of a half, over the square root of 402 pixels in a patch times 3 values,
  // and a half of that for the whole; half of it is negative.
  EXPECT_LT(error_of(mixed.error, std::vector<float>(kMixedValues, 0.F)), 0.2);
  EXPECT_LT(mean_of(mixed.shares[1]), 0.01);
}

/// Clumps in a filtered picture: small, far apart, and each in one of its halves. Relative to
/// themselves they are little noise.
TEST(MixEstimates, ClumpsDoNotMakeTheirOwnErrorSmall) {
  const std::vector<float> truth(kMixedValues, 1.F);
  const Replicates replicates = noisy(truth, 0.3F);
  BiasedEstimate clumpy{truth, Replicates(2, truth)};
  for (std::size_t i = 0; i < kMixedValues; ++i) {
    const std::size_t x = i / 3 % 96;
    const std::size_t y = i / 3 / 96;
    if (x % 16 > 1 || y % 16 > 1) continue;
    clumpy.parts[(x + y) / 16 % 2][i] = 21.F;
    clumpy.pixels[i] = 11.F;
  }
  // Evenly wrong, by less.
  BiasedEstimate even{std::vector<float>(kMixedValues, 1.6F),
                      Replicates(2, std::vector<float>(kMixedValues, 1.6F))};
  const MixedEstimate mixed = mix_estimates(kMixedSize, {clumpy, even}, replicates);
  EXPECT_LT(error_of(mixed.pixels, truth), 0.6 * error_of(clumpy.pixels, truth));
}

/// Filters leave part of the noise of a part in its estimate, which has nothing to do with that of
/// another part.
TEST(MixEstimates, KnowsTheBiasOfHalves) {
  constexpr float kBias = 0.2F;
  constexpr float kNoise = 0.4F;
  const std::vector<float> truth(kMixedValues, 1.F);
  const Replicates replicates = noisy(truth, kNoise);
  BiasedEstimate estimate{truth, {}};
  for (const std::size_t half : {0U, 1U}) {
    std::vector<float>& part =
        estimate.parts.emplace_back(replicate_mean({replicates[half], replicates[half + 2]}));
    for (float& value : part) value = 1.F + kBias + 0.5F * (value - 1.F);
  }
  const MixedEstimate mixed = mix_estimates(kMixedSize, {estimate}, replicates);
  const double bias = std::pow(kBias, 2) / 2;
  const double spread = std::pow(0.5F * kNoise / 2, 2);
  EXPECT_NEAR(error_of(mixed.error, std::vector<float>(kMixedValues, 0.F)),
              std::sqrt(bias + spread), 0.01);
}

TEST(MixEstimates, DistinguishesFirefliesFromLostLight) {
  const std::vector<float> truth(kMixedValues, 1.F);
  Replicates replicates(4, truth);
  replicates[2][3 * (48 * 96 + 48) + 1] = 1000.F;
  const std::vector<BiasedEstimate> estimates = {{truth, Replicates(4, truth)},
                                                 {replicate_mean(replicates), replicates}};
  const MixedEstimate mixed = mix_estimates(kMixedSize, estimates, replicates);
  EXPECT_LT(mixed.pixels[3 * (48 * 96 + 48) + 1], 1.1F);
}

TEST(MixEstimates, FirefliesAreAbsentFromMostReplicates) {
  const std::vector<float> filtered = {1.F, 1.F, 1.F, 0.F};
  // A firefly; a light that the filter lost; a little noise; a light before nothing.
  const Replicates replicates = {
      {1.F, 9.F, 2.F, 5.F}, {0.5F, 10.F, 1.F, 6.F}, {80.F, 11.F, 1.F, 7.F}, {1.F, 10.F, 1.F, 6.F}};
  const std::vector<float> picture = replicate_mean(replicates);
  const std::vector<float> kept = without_fireflies(picture, replicates, filtered);
  EXPECT_EQ(kept[0], 1.F);
  EXPECT_EQ(kept[1], 10.F);
  EXPECT_EQ(kept[2], picture[2]);
  EXPECT_EQ(kept[3], 6.F);
}

TEST(MixEstimates, RefusesOtherSizes) {
  const std::vector<float> picture(kMixedValues, 1.F);
  const Replicates four(4, picture);
  EXPECT_THROW(mix_estimates(kMixedSize, {}, four), std::invalid_argument);
  for (const std::size_t parts : {1U, 5U}) {
    EXPECT_THROW(mix_estimates(kMixedSize, {{picture, Replicates(parts, picture)}}, four),
                 std::invalid_argument);
  }
  EXPECT_THROW(mix_estimates(kMixedSize, {{picture, four, Replicates(3, picture)}}, four),
               std::invalid_argument);
  EXPECT_THROW(mix_estimates({95, 96}, {{picture, four}}, four), std::invalid_argument);
}

}  // namespace
}  // namespace ajar
