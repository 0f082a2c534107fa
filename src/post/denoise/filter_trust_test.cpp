#include "post/denoise/filter_trust.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "image/blur.h"

namespace ajar {
namespace {

constexpr Vec2i kSize{96, 96};
constexpr std::size_t kValues = std::size_t{3} * 96 * 96;

/// Four pictures of `truth` with relative noise, and a filter applied to each and to their mean.
template <typename Filter>
FilterTrust trust_of(const std::vector<float>& truth, float noise, const Filter& filter) {
  std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same test each time
  std::normal_distribution<float> normal;
  Replicates replicates;
  Replicates filtered;
  for (int r = 0; r < 4; ++r) {
    std::vector<float> picture = truth;
    for (float& value : picture) value *= 1.F + noise * normal(random);
    filtered.push_back(filter(picture));
    replicates.push_back(std::move(picture));
  }
  const std::vector<float> mean = replicate_mean(replicates);
  return trust_filter(kSize, mean, filter(mean), replicates, filtered);
}

std::vector<float> smooth(const std::vector<float>& picture) {
  return blurred(picture, kSize, 4.0);
}

double mean_of(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += double{value};
  return sum / static_cast<double>(values.size());
}

double relative_error_of(const std::vector<float>& picture, const std::vector<float>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    sum += std::pow(double{picture[i]} / truth[i] - 1.0, 2);
  }
  return std::sqrt(sum / static_cast<double>(picture.size()));
}

/// Stripes of two pixels: a blur of four takes all of them away.
std::vector<float> stripes() {
  std::vector<float> truth(kValues);
  for (std::size_t i = 0; i < kValues; ++i) truth[i] = i / 3 % 4 < 2 ? 1.5F : 0.5F;
  return truth;
}

TEST(FilterTrust, TrustsAFilterThatIsRight) {
  const std::vector<float> truth(kValues, 0.7F);
  const FilterTrust trust = trust_of(truth, 0.5F, smooth);
  EXPECT_LT(mean_of(trust.unfiltered), 0.05);
  EXPECT_LT(relative_error_of(trust.pixels, truth), 0.05) << "the mean has 0.25";
}

TEST(FilterTrust, ShowsTheUnfilteredPictureWhereTheFilterHarms) {
  const FilterTrust trust = trust_of(stripes(), 0.1F, smooth);
  EXPECT_GT(mean_of(trust.unfiltered), 0.9);
  EXPECT_LT(relative_error_of(trust.pixels, stripes()), 0.1) << "the filter makes 0.7 of it";
}

/// What makes the whole consistent: with less noise the share of a filter that is wrong falls with
/// the variance.
TEST(FilterTrust, FallsToNothingAsNoiseDoes) {
  const double some = 1.0 - mean_of(trust_of(stripes(), 0.4F, smooth).unfiltered);
  const double less = 1.0 - mean_of(trust_of(stripes(), 0.1F, smooth).unfiltered);
  const double least = 1.0 - mean_of(trust_of(stripes(), 0.025F, smooth).unfiltered);
  EXPECT_NEAR(less / some, 1.0 / 16, 0.02);
  EXPECT_NEAR(least / less, 1.0 / 16, 0.02);
}

TEST(FilterTrust, KnowsTheErrorThatIsLeft) {
  for (const float noise : {0.1F, 0.4F}) {
    const FilterTrust trust = trust_of(stripes(), noise, smooth);
    double said = 0.0;
    double real = 0.0;
    for (std::size_t i = 0; i < kValues; ++i) {
      said += std::pow(double{trust.error[i]}, 2);
      real += std::pow(double{trust.pixels[i]} - stripes()[i], 2);
    }
    EXPECT_NEAR(std::sqrt(said / real), 1.0, 0.2) << noise;
  }
}

TEST(FilterTrust, TakesNoFireflyForLightThatTheFilterLost) {
  const std::vector<float> truth(kValues, 1.F);
  Replicates replicates(4, truth);
  replicates[2][3 * (48 * 96 + 48) + 1] = 1000.F;
  const Replicates filtered(4, truth);
  const FilterTrust trust =
      trust_filter(kSize, replicate_mean(replicates), truth, replicates, filtered);
  EXPECT_EQ(mean_of(trust.unfiltered), 0.0);
}

TEST(FilterTrust, RefusesWhatDoesNotFit) {
  const std::vector<float> picture(kValues, 1.F);
  EXPECT_THROW(
      trust_filter(kSize, picture, picture, Replicates(3, picture), Replicates(3, picture)),
      std::invalid_argument);
  EXPECT_THROW(
      trust_filter({95, 96}, picture, picture, Replicates(4, picture), Replicates(4, picture)),
      std::invalid_argument);
}

}  // namespace
}  // namespace ajar
