#include "integrator/regions/impulse_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace ajar {
namespace {

/// One channel.
std::vector<float> constant(Vec2i size, float value) {
  return std::vector<float>(static_cast<std::size_t>(size.x * size.y), value);
}

TEST(ImpulseNoise, OfAnEvenPictureIsZero) {
  for (const float value : {0.F, 1.F, -3.F, 1e38F}) {
    for (const Vec2i& size : {Vec2i(1, 1), Vec2i(1, 9), Vec2i(9, 1), Vec2i(7, 4)}) {
      for (const float noise : impulse_noise(size, constant(size, value), 5).values) {
        EXPECT_EQ(noise, 0.F) << value;
      }
    }
  }
}

TEST(ImpulseNoise, FindsAnImpulseAndNothingElse) {
  const Vec2i size(9, 6);
  for (const int window : {3, 5}) {
    // In the middle, at the edge, and in the corner, where the window has 4 or 9 pixels.
    for (const std::size_t place : {std::size_t{31}, std::size_t{4}, std::size_t{0}}) {
      std::vector<float> pixels = constant(size, 2.F);
      pixels[place] = 12.F;
      const Plane noise = impulse_noise(size, pixels, window);
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        EXPECT_EQ(noise.values[i], i == place ? 1.F : 0.F) << window << ", " << i;
      }
    }
  }
}

TEST(ImpulseNoise, LeavesStraightEdgesAlone) {
  const Vec2i size(10, 8);
  std::vector<float> pixels;
  pixels.reserve(80);
  for (int i = 0; i < size.x * size.y; ++i) pixels.push_back(i % size.x < 5 ? 0.F : 1.F);
  for (const float noise : impulse_noise(size, pixels, 3).values) EXPECT_EQ(noise, 0.F);
}

TEST(ImpulseNoise, IsTheDifferenceFromTheMedianByHand) {
  // Windows of the row: {1, 4}, {1, 4, 2}, {4, 2, 10}, {2, 10}; medians 2.5, 2, 4, 6.
  const Plane noise = impulse_noise(Vec2i(4, 1), std::vector<float>{1.F, 4.F, 2.F, 10.F}, 3);
  EXPECT_EQ(noise.values, (std::vector<float>{1.5F / 4, 2.F / 4, 2.F / 4, 4.F / 4}));
  const Plane column = impulse_noise(Vec2i(1, 4), std::vector<float>{1.F, 4.F, 2.F, 10.F}, 3);
  EXPECT_EQ(column.values, noise.values);
}

TEST(ImpulseNoise, IsThatOfTheNoisiestChannel) {
  const Vec2i size(5, 5);
  std::vector<float> pixels(75, 1.F);
  pixels[12 * 3 + 0] = 3.F;   // by 2
  pixels[12 * 3 + 2] = -4.F;  // by 5
  pixels[18 * 3 + 1] = 5.F;   // by 4
  const Plane noise = impulse_noise(size, pixels, 3);
  EXPECT_EQ(noise.values[12], 1.F);
  EXPECT_EQ(noise.values[18], 0.8F);
}

TEST(ImpulseNoise, TakesWhatIsNotFiniteForUnknown) {
  const float infinity = std::numeric_limits<float>::infinity();
  const Vec2i size(5, 5);
  for (const float bad : {std::nanf(""), infinity, -infinity}) {
    std::vector<float> pixels = constant(size, 1.F);
    pixels[7] = bad;
    pixels[12] = 2.F;
    const Plane noise = impulse_noise(size, pixels, 3);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      EXPECT_EQ(noise.values[i], i == 12 ? 1.F : 0.F) << i;
    }
    for (const float value : impulse_noise(size, constant(size, bad), 5).values) {
      EXPECT_EQ(value, 0.F);
    }
  }
}

TEST(ImpulseNoise, BearsTheLargestDifferences) {
  const float most = std::numeric_limits<float>::max();
  const Plane noise = impulse_noise(Vec2i(3, 1), std::vector<float>{-most, -most, most}, 3);
  EXPECT_EQ(noise.values, (std::vector<float>{0.F, 0.F, 1.F}));
}

TEST(ImpulseNoise, EqualsItsDefinitionOnRandomPictures) {
  std::mt19937 generator(4);
  std::uniform_real_distribution<float> uniform;
  const Vec2i size(13, 7);
  std::vector<float> pixels = constant(size, 0.F);
  for (float& value : pixels) value = uniform(generator);
  for (const int window : {3, 5}) {
    std::vector<double> expected;
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        std::vector<double> values;
        for (int i = 0; i < size.x * size.y; ++i) {
          if (std::abs(i % size.x - x) > window / 2 || std::abs(i / size.x - y) > window / 2)
            continue;
          values.push_back(pixels[static_cast<std::size_t>(i)]);
        }
        std::sort(values.begin(), values.end());
        const double median = 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
        const int place = y * size.x + x;
        expected.push_back(std::abs(pixels[static_cast<std::size_t>(place)] - median));
      }
    }
    const double largest = *std::max_element(expected.begin(), expected.end());
    const Plane noise = impulse_noise(size, pixels, window);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(noise.values[i], expected[i] / largest, 1e-6) << window << ", " << i;
    }
  }
}

TEST(ImpulseNoise, RefusesWhatIsNoPicture) {
  EXPECT_THROW(impulse_noise(Vec2i(2, 2), std::vector<float>(5)), std::invalid_argument);
  EXPECT_THROW(impulse_noise(Vec2i(2, 2), std::vector<float>()), std::invalid_argument);
  EXPECT_THROW(impulse_noise(Vec2i(0, 2), std::vector<float>(4)), std::invalid_argument);
  EXPECT_THROW(impulse_noise(Vec2i(2, 2), std::vector<float>(4), 4), std::invalid_argument);
}

}  // namespace
}  // namespace ajar
