#include "image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "image/hdr_flip.h"
#include "image/testing/pattern.h"
#include "image/tone_curve.h"

// The numbers were computed by a program of ours in NumPy: in double precision, with
// two-dimensional kernels made from the formulas and applied directly to planes with repeated
// borders (here: products of one-dimensional kernels, in single precision).
namespace ajar {
namespace {

using testing_images::brighter_patch;
using testing_images::kPatternSize;
using testing_images::pattern;

/// Rounding in single precision: the power 0.7 amplifies that of small colour differences.
constexpr double kTolerance = 5e-5;

float at(const std::vector<float>& map, std::size_t x, std::size_t y) {
  return map[y * static_cast<std::size_t>(kPatternSize.x) + x];
}

std::vector<float> uniform(Vec2i size, const std::vector<float>& color) {
  std::vector<float> image;
  for (int i = 0; i < size.x * size.y; ++i) image.insert(image.end(), color.begin(), color.end());
  return image;
}

double uniform_flip(const std::vector<float>& image, const std::vector<float>& reference) {
  const Vec2i size{16, 16};
  return map_mean(flip_map(uniform(size, image), uniform(size, reference), size));
}

/// Scene-linear, up to 20, from a pattern of display values.
std::vector<float> lamps(int phase) {
  std::vector<float> linear = pattern(phase);
  for (float& v : linear) {
    v = linear_from_srgb(v);
    v = v * v * 20.F + 0.01F;
  }
  return linear;
}

TEST(Flip, EqualImagesDoNotDiffer) {
  const std::vector<float> image = pattern(1);
  const std::vector<float> map = flip_map(image, image, kPatternSize);
  EXPECT_EQ(*std::max_element(map.begin(), map.end()), 0.F);
}

TEST(Flip, OfUniformColors) {
  EXPECT_NEAR(uniform_flip({0, 0, 0}, {1, 1, 1}), 0.9673797619667203, kTolerance);
  EXPECT_NEAR(uniform_flip({0, 1, 0}, {0, 0, 1}), 1.0, kTolerance) << "the largest difference";
  EXPECT_NEAR(uniform_flip({0.5F, 0.5F, 0.5F}, {0.55F, 0.55F, 0.55F}), 0.17646105611014282,
              kTolerance);
  EXPECT_NEAR(uniform_flip({1, 0, 0}, {0, 1, 0}), 0.986662275361864, kTolerance);
}

TEST(Flip, IsSymmetric) {
  const std::vector<float> forth = flip_map(pattern(0), pattern(1), kPatternSize);
  const std::vector<float> back = flip_map(pattern(1), pattern(0), kPatternSize);
  for (std::size_t i = 0; i < forth.size(); ++i) EXPECT_EQ(forth[i], back[i]);
}

TEST(Flip, MatchesAnIndependentImplementation) {
  const std::vector<float> map = flip_map(pattern(1), pattern(0), kPatternSize);
  EXPECT_NEAR(map_mean(map), 0.4527904388643869, kTolerance);
  EXPECT_NEAR(at(map, 0, 0), 0.31068185529260584, kTolerance);
  EXPECT_NEAR(at(map, 20, 15), 0.4614484873958113, kTolerance);
  EXPECT_NEAR(at(map, 39, 29), 0.8520347654239311, kTolerance);
  EXPECT_NEAR(*std::max_element(map.begin(), map.end()), 0.8934782750653864, kTolerance);
}

TEST(Flip, MatchesAnIndependentImplementationSeenFromNearby) {
  const std::vector<float> map = flip_map(pattern(1), pattern(0), kPatternSize, 30.0);
  EXPECT_NEAR(map_mean(map), 0.733035200226296, kTolerance);
  EXPECT_NEAR(at(map, 0, 0), 0.3177918707801431, kTolerance);
  EXPECT_NEAR(at(map, 20, 15), 0.9739907328697438, kTolerance);
}

TEST(Flip, FindsAPatchWhereItIs) {
  const std::vector<float> map = flip_map(brighter_patch(pattern(1)), pattern(1), kPatternSize);
  EXPECT_NEAR(map_mean(map), 0.11032879493576458, kTolerance);
  EXPECT_NEAR(at(map, 20, 15), 0.46196739126716024, kTolerance);
  EXPECT_NEAR(at(map, 10, 10), 0.35922650161485553, kTolerance);
  // Five pixels from the patch, where the tails of the filters end: rounding shows.
  EXPECT_NEAR(at(map, 5, 5), 0.0004307740681064606, 1e-4);
}

TEST(Flip, RefusesImagesThatDoNotFit) {
  EXPECT_THROW(flip_map(pattern(0), pattern(1), {40, 29}), std::invalid_argument);
  EXPECT_THROW(flip_map(pattern(0), pattern(1), kPatternSize, 0.0), std::invalid_argument);
}

TEST(HdrFlip, MatchesAnIndependentImplementation) {
  const auto exposures = hdr_flip_exposures(lamps(0));
  ASSERT_TRUE(exposures);
  EXPECT_NEAR(exposures->start, -3.0613027533114474, 1e-5);
  EXPECT_NEAR(exposures->stop, -0.048155943997501796, 1e-5);
  EXPECT_EQ(exposures->count, 4);
  const std::vector<float> map = hdr_flip_map(lamps(1), lamps(0), kPatternSize, *exposures);
  EXPECT_NEAR(map_mean(map), 0.5577785191506848, kTolerance);
  EXPECT_NEAR(at(map, 20, 15), 0.5137743816793404, kTolerance);
}

TEST(HdrFlip, SeesDifferencesBeyondTheDisplay) {
  const Vec2i size{16, 16};
  std::vector<float> lamp = uniform(size, {0.2F, 0.2F, 0.2F});
  for (std::size_t i = 0; i < 48; ++i) lamp[i] = 50.F;
  std::vector<float> dimmer = lamp;
  for (std::size_t i = 0; i < 48; ++i) dimmer[i] = 10.F;
  EXPECT_EQ(map_mean(flip_map(to_ldr(dimmer), to_ldr(lamp), size)), 0.0);
  const auto exposures = hdr_flip_exposures(lamp);
  ASSERT_TRUE(exposures);
  EXPECT_GT(map_mean(hdr_flip_map(dimmer, lamp, size, *exposures)), 0.01);
}

TEST(HdrFlip, ExposuresAreThoseOfLitPixelsInTheDarkAndNoneInBlack) {
  std::vector<float> reference(3 * 100, 0.F);
  EXPECT_FALSE(hdr_flip_exposures(reference));
  for (std::size_t i = 0; i < 3 * 20; ++i) reference[i] = 1.F;
  const auto few = hdr_flip_exposures(reference);
  ASSERT_TRUE(few);
  EXPECT_DOUBLE_EQ(few->start, few->stop);
  EXPECT_EQ(few->count, 2);
}

}  // namespace
}  // namespace ajar
