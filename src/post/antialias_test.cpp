#include "post/antialias.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <vector>

namespace ajar {
namespace {

Plane everywhere(Vec2i size) {
  Plane mask(size);
  std::fill(mask.values.begin(), mask.values.end(), 1.F);
  return mask;
}

/// A picture of a shape in two colours, from `samples`² points per pixel.
std::vector<float> picture_of(Vec2i size, int samples,
                              const std::function<bool(double, double)>& inside) {
  std::vector<float> pixels;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      int hits = 0;
      for (int i = 0; i < samples; ++i) {
        for (int j = 0; j < samples; ++j) {
          if (inside(x + (j + 0.5) / samples, y + (i + 0.5) / samples)) ++hits;
        }
      }
      const float share = static_cast<float>(hits) / static_cast<float>(samples * samples);
      pixels.insert(pixels.end(), {0.2F + 0.7F * share, 0.3F + 0.5F * share, 0.9F - 0.2F * share});
    }
  }
  return pixels;
}

/// Mean square of the difference, without the pixels near the border.
double error(Vec2i size, const std::vector<float>& a, const std::vector<float>& b) {
  constexpr int kMargin = 12;
  double sum = 0.0;
  for (int y = kMargin; y < size.y - kMargin; ++y) {
    for (int x = kMargin; x < size.x - kMargin; ++x) {
      const auto i = 3 * static_cast<std::size_t>(y * size.x + x);
      for (std::size_t c = i; c < i + 3; ++c) sum += std::pow(static_cast<double>(a[c] - b[c]), 2);
    }
  }
  return sum;
}

TEST(Antialias, BringsSlantedEdgesNearerToTheTruth) {
  const Vec2i size(72, 56);
  for (const double slope : {0.07, 0.13, 0.21, 0.34, -0.11, -0.29}) {
    for (const bool steep : {false, true}) {
      for (const bool bright_side : {false, true}) {
        const auto inside = [&](double x, double y) {
          const double value =
              steep ? x - 36.3 - slope * (y - 28.1) : y - 28.1 - slope * (x - 36.3);
          return (value > 0.0) == bright_side;
        };
        const auto stairs = picture_of(size, 1, inside);
        const auto truth = picture_of(size, 16, inside);
        const auto smooth = antialias(size, stairs, everywhere(size));
        EXPECT_LT(error(size, smooth, truth), 0.25 * error(size, stairs, truth))
            << slope << (steep ? ", steep" : "");
      }
    }
  }
}

TEST(Antialias, BringsADiscNearerToTheTruth) {
  const Vec2i size(72, 64);
  const auto inside = [](double x, double y) { return std::hypot(x - 35.7, y - 31.2) < 18.4; };
  const auto stairs = picture_of(size, 1, inside);
  const auto truth = picture_of(size, 16, inside);
  const auto smooth = antialias(size, stairs, everywhere(size));
  EXPECT_LT(error(size, smooth, truth), 0.5 * error(size, stairs, truth));
}

TEST(Antialias, LeavesEvenPicturesAndStraightEdgesAlone) {
  for (const Vec2i& size : {Vec2i(1, 1), Vec2i(1, 20), Vec2i(20, 1), Vec2i(17, 9)}) {
    const auto even = picture_of(size, 1, [](double, double) { return true; });
    EXPECT_EQ(antialias(size, even, everywhere(size)), even);
    const auto columns = picture_of(size, 1, [](double x, double) { return x < 8.0; });
    EXPECT_EQ(antialias(size, columns, everywhere(size)), columns);
    const auto rows = picture_of(size, 1, [](double, double y) { return y < 8.0; });
    EXPECT_EQ(antialias(size, rows, everywhere(size)), rows);
  }
}

TEST(Antialias, KeepsInvisibleEdges) {
  const Vec2i size(30, 20);
  auto pixels = picture_of(size, 1, [](double x, double y) { return y > 10.0 + 0.2 * (x - 15.0); });
  for (float& value : pixels) value = 0.5F + 0.02F * value;
  EXPECT_EQ(antialias(size, pixels, everywhere(size)), pixels);
}

TEST(Antialias, ChangesNothingOutsideItsMask) {
  std::mt19937 generator(3);
  const Vec2i size(40, 30);
  std::vector<float> pixels(3600);
  for (float& value : pixels) value = static_cast<float>(generator() % 256) / 255.F;
  Plane mask(size);
  EXPECT_EQ(antialias(size, pixels, mask), pixels);
  for (std::size_t i = 0; i < mask.values.size(); ++i) mask.values[i] = i % 3 == 0 ? 1.F : 0.F;
  const auto result = antialias(size, pixels, mask);
  const auto whole = antialias(size, pixels, everywhere(size));
  EXPECT_NE(result, pixels);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_EQ(result[i], (i / 3 % 3 == 0 ? whole : pixels)[i]) << i;
  }
}

TEST(Antialias, IsScaledByItsMask) {
  const Vec2i size(30, 20);
  const auto pixels =
      picture_of(size, 1, [](double x, double y) { return y > 10.0 + 0.2 * (x - 15.0); });
  Plane half = everywhere(size);
  for (float& value : half.values) value = 0.5F;
  const auto whole = antialias(size, pixels, everywhere(size));
  const auto result = antialias(size, pixels, half);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_NEAR(result[i], 0.5F * (pixels[i] + whole[i]), 1e-6F);
  }
}

TEST(Antialias, StaysBetweenThePixelsItBlends) {
  std::mt19937 generator(5);
  for (const Vec2i& size : {Vec2i(31, 23), Vec2i(1, 40), Vec2i(40, 1), Vec2i(2, 2)}) {
    std::vector<float> pixels(3 * static_cast<std::size_t>(size.x * size.y));
    for (float& value : pixels) value = static_cast<float>(generator() % 2);
    for (const float value : antialias(size, pixels, everywhere(size))) {
      EXPECT_GE(value, 0.F);
      EXPECT_LE(value, 1.F);
    }
  }
}

TEST(Antialias, RefusesOtherSizes) {
  EXPECT_THROW(antialias(Vec2i(2, 2), std::vector<float>(12), Plane(Vec2i(4, 1))),
               std::invalid_argument);
  EXPECT_THROW(antialias(Vec2i(2, 2), std::vector<float>(4), Plane(Vec2i(2, 2))),
               std::invalid_argument);
}

}  // namespace
}  // namespace ajar
