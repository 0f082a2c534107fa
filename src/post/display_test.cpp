#include "post/display.h"

#include <gtest/gtest.h>

#include <cmath>

#include "post/antialias.h"

namespace ajar {
namespace {

Picture picture_of(Vec2i size, std::vector<float> pixels) {
  Picture picture;
  picture.resolution = size + Vec2i(3, 2);
  picture.crop = Box2i(Vec2i(1, 2), Vec2i(1, 2) + size - Vec2i(1, 1));
  picture.layers = {{"", 3, std::move(pixels)}, {"depth", 1, std::vector<float>(16, 7.F)}};
  picture.metadata = {{"ajar:seed", "3"}};
  return picture;
}

TEST(Display, ShowsTheFirstLayerThroughTheCurveAtItsExposure) {
  const Picture shown = displayed(
      picture_of({1, 2}, {0.107F, 0.F, 9.F, std::nanf(""), -1.F, 0.02F}), {ToneMap::Srgb, 1.F});
  ASSERT_EQ(shown.layers.size(), 1U);
  const std::vector<float>& values = shown.layers.front().pixels;
  EXPECT_NEAR(values[0], 0.5F, 0.001F);
  EXPECT_EQ(values[1], 0.F);
  EXPECT_NEAR(values[2], 1.F, 1e-6F);
  EXPECT_EQ(values[3], 0.F);
  EXPECT_EQ(values[4], 0.F);
  EXPECT_FLOAT_EQ(values[5], srgb_from_linear(0.04F));
}

TEST(Display, KeepsPlaceAndMetadata) {
  const Picture picture = picture_of({2, 1}, std::vector<float>(6, 0.5F));
  const Picture shown = displayed(picture, {});
  EXPECT_EQ(shown.resolution, picture.resolution);
  EXPECT_EQ(shown.crop.min, picture.crop.min);
  EXPECT_EQ(shown.crop.max, picture.crop.max);
  EXPECT_EQ(shown.metadata, picture.metadata);
}

/// The seams of `selective`, say, where a mask says that there are some.
TEST(Display, SmoothsEdgesOnlyWhereTheMaskAllowsIt) {
  const Vec2i size(24, 12);
  std::vector<float> stairs;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) stairs.insert(stairs.end(), 3, 4 * y > x + 10 ? 0.9F : 0.05F);
  }
  Picture picture = picture_of(size, stairs);
  const std::vector<float> plain = displayed(picture, {}).layers.front().pixels;
  picture.antialias_mask.emplace(size);
  EXPECT_EQ(displayed(picture, {}).layers.front().pixels, plain);
  for (float& value : picture.antialias_mask->values) value = 1.F;
  EXPECT_EQ(displayed(picture, {}).layers.front().pixels,
            antialias(size, plain, *picture.antialias_mask));
  EXPECT_NE(displayed(picture, {}).layers.front().pixels, plain);
}

}  // namespace
}  // namespace ajar
