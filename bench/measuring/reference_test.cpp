#include "measuring/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "image/metrics.h"

namespace ajar::bench {
namespace {

/// A picture of ones with Gaussian noise.
std::vector<float> noisy(std::size_t values, double sigma, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(1.0, sigma);
  std::vector<float> picture(values);
  for (float& value : picture) value = static_cast<float>(normal(generator));
  return picture;
}

constexpr std::size_t kValues = 3 * 20000;

TEST(Reference, PartsAreWeightedBySamples) {
  const std::vector<ReferencePart> parts = {
      {{1.F, 2.F, 3.F}, {0.1F, 0.F, 0.F}, 300, 10.0},
      {{5.F, 2.F, 1.F}, {0.3F, 0.F, 0.F}, 100, 4.0},
  };
  const Reference reference = average(parts);
  EXPECT_EQ(reference.picture, (std::vector<float>{2.F, 2.F, 2.5F}));
  EXPECT_EQ(reference.samples, 400U);
  EXPECT_EQ(reference.cpu_seconds, 14.0);
  EXPECT_EQ(reference.parts, 2U);
  // Variance of the first value: (3/4·0.1)² + (1/4·0.3)².
  EXPECT_NEAR(reference.floor.plain, 2 * 0.075 * 0.075 / 4.01 / 3, 1e-7);
}

TEST(Reference, HalvesOfAPairAreIndependentAndWeighMethodsAlike) {
  // Light of a hundredth of the pixels, which the second method has as fireflies in others.
  std::vector<float> truth(kValues, 1.F);
  for (std::size_t i = 0; i < kValues; i += 300) truth[i] = truth[i + 1] = truth[i + 2] = 5.F;
  const auto by_good = [&](unsigned seed) {
    std::vector<float> picture = noisy(kValues, 0.05, seed);
    for (std::size_t i = 0; i < kValues; ++i) picture[i] += truth[i] - 1.F;
    return picture;
  };
  const auto by_bad = [&](unsigned seed) {
    std::vector<float> picture = noisy(kValues, 0.05, seed);
    for (std::size_t i = seed * 90; i < kValues; i += 600) picture[i] += 2400.F;
    return picture;
  };
  const std::vector<std::array<std::vector<float>, 2>> both = {{by_good(2), by_good(3)},
                                                               {by_bad(4), by_bad(5)}};
  const ReferencePair pair = reference_pair(both);
  // A picture without that light has that as its error, not the nothing that the second sees.
  const std::vector<float> dark(kValues, 1.F);
  const double missing = 0.01 * 16.0 / 25.01;
  EXPECT_NEAR(own_error(dark, both[1][0], both[1][1]).trimmed, 0.0, 0.2 * missing);
  EXPECT_NEAR(own_error(dark, pair.halves[0], pair.halves[1]).plain, missing, 0.1 * missing);
  // The mean of two has half of the squared noise of either.
  EXPECT_NEAR(pair.floor.trimmed, 0.05 * 0.05 / 2.0 / 1.01, 1e-4);
  EXPECT_THROW(reference_pair({}), std::invalid_argument);
}

TEST(Reference, NoiseIsNotInAPicturesOwnError) {
  constexpr double kSigma = 0.05;
  const std::vector<float> picture = noisy(kValues, kSigma, 1);
  const double own = kSigma * kSigma / 1.01;
  for (const double noise : {0.0, 0.05, 0.1}) {
    const std::vector<float> first = noisy(kValues, noise, 2);
    const std::vector<float> second = noisy(kValues, noise, 3);
    const OwnError error = own_error(picture, first, second);
    // Products are known to (own + noise²)/245, and five times that is allowed, beside the part of
    // pixels where the references differ.
    const double allowed = 5.0 * (own + noise * noise) / 245.0 + 0.04 * noise * noise;
    EXPECT_NEAR(error.plain, own, allowed) << noise;
    EXPECT_LT(error.trimmed, error.plain);
    EXPECT_GT(error.trimmed, 0.97 * error.plain);
  }
}

TEST(Reference, OwnErrorDistinguishesFirefliesOfPictureAndReferences) {
  std::vector<float> picture(kValues, 1.F);
  std::vector<float> first = picture;
  const std::vector<float> second = picture;
  first[300] = 1e4F;
  EXPECT_EQ(own_error(picture, first, second).plain, 0.0);
  picture[600] = 101.F;
  const OwnError error = own_error(picture, first, second);
  EXPECT_NEAR(error.plain, 1e4 / 1.01 / (0.99 * kValues), 1e-6);
  EXPECT_EQ(error.trimmed, 0.0);
  EXPECT_THROW(own_error(picture, first, {}), std::invalid_argument);
  EXPECT_THROW(own_error({}, {}, {}), std::invalid_argument);
}

TEST(Reference, FloorIsTheErrorThatItsNoiseCauses) {
  constexpr double kSigma = 0.05;
  const std::vector<float> truth(kValues, 1.F);
  const std::vector<float> error(kValues, static_cast<float>(kSigma));
  const NoiseFloor floor = noise_floor(truth, error);
  // 60 000 squares of normal numbers: their mean is known to 0.6 %; five of these are allowed.
  EXPECT_NEAR(relative_mse(noisy(kValues, kSigma, 1), truth) / floor.plain, 1.0, 0.03);
  EXPECT_NEAR(floor.trimmed, floor.plain, 1e-9) << "equal noise everywhere leaves nothing to trim";
}

TEST(Reference, IndependentPictureIsWeighedByItsNoise) {
  constexpr double kOurs = 0.02;
  constexpr double kTheirs = 0.04;
  const std::vector<ReferencePart> parts = {
      {noisy(kValues, kOurs, 1), std::vector<float>(kValues, static_cast<float>(kOurs)), 8, 1.0}};
  const Reference ours = average(parts);
  const Reference mixed = average_with(ours, noisy(kValues, kTheirs, 2));
  // Best weights are 4/5 and 1/5, and the floor is then 4/5 of ours. Trimming takes the tail of
  // the noise from the difference but not from our floor: about 1 %.
  EXPECT_NEAR(mixed.floor.trimmed / ours.floor.trimmed, 0.8, 0.02);
  EXPECT_NEAR(mixed.floor.plain / ours.floor.plain, 0.8, 0.02);
  const std::vector<float> truth(kValues, 1.F);
  EXPECT_NEAR(relative_mse(mixed.picture, truth) / mixed.floor.plain, 1.0, 0.05);
}

TEST(Reference, EqualPicturesStayAsTheyAre) {
  const std::vector<ReferencePart> parts = {{{1.F, 2.F, 3.F}, {0.F, 0.F, 0.F}, 4, 1.0}};
  const Reference mixed = average_with(average(parts), parts[0].picture);
  EXPECT_EQ(mixed.picture, parts[0].picture);
  EXPECT_EQ(mixed.floor.plain, 0.0);
}

}  // namespace
}  // namespace ajar::bench
