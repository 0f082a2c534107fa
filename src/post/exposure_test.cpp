#include "post/exposure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ajar {
namespace {

constexpr Vec2i kPictureSize(320, 240);
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A grey picture with the value of `at(x, y)`.
template <typename At>
std::vector<float> picture(At at) {
  std::vector<float> rgb;
  for (int y = 0; y < kPictureSize.y; ++y) {
    for (int x = 0; x < kPictureSize.x; ++x) rgb.insert(rgb.end(), 3, at(x, y));
  }
  return rgb;
}

float exposure_of(const std::vector<float>& rgb) { return fitting_exposure(rgb, kPictureSize); }

TEST(Exposure, BringsAnEvenPictureToMiddleGrey) {
  for (const float stops : {-20.F, -2.5F, 0.F, 0.1F, 7.F}) {
    const float value = 0.18F * std::exp2(-stops);
    EXPECT_FLOAT_EQ(exposure_of(picture([&](int, int) { return value; })), stops);
  }
  EXPECT_EQ(exposure_of(picture([](int, int) { return 0.F; })), 0.F);
  EXPECT_EQ(exposure_of(picture([](int, int) { return 1e-37F; })), kMostStops);
  EXPECT_EQ(fitting_exposure(std::vector<float>(3, 0.18F), {1, 1}), 0.F);
}

TEST(Exposure, IsNotDecidedByFireflies) {
  // One in a thousand pixels, in one of ten blocks.
  for (const float firefly : {1e3F, 1e30F, kInfinity, std::nanf(""), -1e3F}) {
    const auto rgb =
        picture([&](int x, int y) { return x % 100 == 0 && y % 10 == 0 ? firefly : 0.18F; });
    EXPECT_NEAR(exposure_of(rgb), 0.F, 0.11F) << firefly;
  }
}

TEST(Exposure, OfNoiseIsThatOfItsMean) {
  // Light of one pixel in fifty, which most samples miss, is found.
  const auto rgb = picture([](int x, int y) { return (x + 7 * y) % 50 == 0 ? 9.F : 0.F; });
  EXPECT_NEAR(exposure_of(rgb), 0.F, 0.2F);
}

TEST(Exposure, IsNotDecidedByALampOrTheNightAround) {
  const auto lamp = picture([](int x, int y) { return x < 80 && y < 80 ? 1e3F : 0.18F; });
  EXPECT_NEAR(exposure_of(lamp), 0.F, 0.2F);
  const auto night = picture([](int x, int y) { return x < 60 && y < 60 ? 0.18F : 0.F; });
  EXPECT_NEAR(exposure_of(night), 0.F, 0.2F);
}

TEST(Exposure, LeavesThreeQuartersBelowWhite) {
  // Half of it is lit, half nearly dark: grey between them would be white in the lit half.
  const auto halves = picture([](int x, int) { return x < kPictureSize.x / 2 ? 1.F : 0.001F; });
  EXPECT_EQ(exposure_of(halves), 0.F);
}

TEST(Exposure, ClippingCountsBlackAndWhitePixels) {
  const auto halves = picture([](int x, int) { return x < kPictureSize.x / 4 ? 2.F : 0.001F; });
  EXPECT_DOUBLE_EQ(clipping(halves, ToneMap::Srgb, 0.F).white, 0.25);
  EXPECT_DOUBLE_EQ(clipping(halves, ToneMap::Srgb, 0.F).black, 0.75);
  EXPECT_DOUBLE_EQ(clipping(halves, ToneMap::Srgb, -1.1F).white, 0.0);
  EXPECT_DOUBLE_EQ(clipping(halves, ToneMap::Srgb, 3.F).black, 0.0);
  EXPECT_DOUBLE_EQ(clipping(halves, ToneMap::Filmic, 0.F).white, 0.0);
  EXPECT_DOUBLE_EQ(clipping(halves, ToneMap::Filmic, 4.F).white, 0.25);
  // A wall in warm light is lost, though blue is not.
  EXPECT_EQ(clipping(std::vector<float>{2.F, 1.5F, 0.8F}, ToneMap::Srgb, 0.F).white, 1.0);
  EXPECT_EQ(clipping(std::vector<float>{1.F, 0.F, 0.F}, ToneMap::Srgb, 0.F).white, 0.0);
}

}  // namespace
}  // namespace ajar
