#include "image/blur.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

namespace ajar {
namespace {

constexpr Vec2i kBlurredSize{96, 80};

TEST(Blur, SpreadsAPointAsAGaussianOfItsWidth) {
  std::vector<float> point(std::size_t{3} * 96 * 80);
  point[3 * (40 * 96 + 50) + 1] = 1.F;
  const std::vector<float> spread = blurred(point, kBlurredSize, 3.0);
  double sum = 0.0;
  double square = 0.0;
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 96; ++x) {
      const double value = spread[3 * static_cast<std::size_t>(y * 96 + x) + 1];
      sum += value;
      square += value * (x - 50) * (x - 50);
    }
  }
  EXPECT_NEAR(sum, 1.0, 1e-5);
  EXPECT_NEAR(square, 9.0, 0.05);
  EXPECT_EQ(std::accumulate(spread.begin(), spread.end(), 0.0), sum) << "other channels stay black";
}

TEST(Blur, KeepsAnEvenPicture) {
  for (const float value :
       blurred(std::vector<float>(std::size_t{3} * 96 * 80, 0.7F), kBlurredSize, 8.0)) {
    ASSERT_NEAR(value, 0.7F, 1e-5F);
  }
}

/// Premise of the error by scale: a Gaussian leaves 1/(4πσ²) of independent noise.
TEST(Blur, ReducesIndependentNoiseByTheTheoreticalFactor) {
  std::mt19937 random(3);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same test each time
  std::normal_distribution<float> normal;
  constexpr Vec2i kLarge{400, 400};
  std::vector<float> noise(std::size_t{3} * 400 * 400);
  for (float& value : noise) value = normal(random);
  for (const double sigma : {1.0, 2.0, 4.0}) {
    const std::vector<float> left = blurred(noise, kLarge, sigma);
    double square = 0.0;
    std::size_t count = 0;
    for (std::size_t y = 40; y < 360; ++y) {
      for (std::size_t i = 3 * (400 * y + 40); i < 3 * (400 * y + 360); ++i, ++count) {
        square += double{left[i]} * left[i];
      }
    }
    // 3 · 320² values that hang together over 4πσ² each: at σ = 4 a standard deviation of 3.6 %.
    EXPECT_NEAR(square / static_cast<double>(count) * 4 * M_PI * sigma * sigma, 1.0, 0.1) << sigma;
  }
}

TEST(Blur, RefusesAnotherSize) {
  EXPECT_THROW(blurred(std::vector<float>(12), kBlurredSize, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace ajar
