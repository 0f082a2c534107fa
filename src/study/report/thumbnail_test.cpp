#include "study/report/thumbnail.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ajar {
namespace {

TEST(Thumbnail, AveragesAndKeepsTheShape) {
  ReportImage image{"wide", 1024, 512, {{"", 3, std::vector<float>(3 * 1024 * 512, 0.5F)}}, {}, {}};
  // One of the 16 pixels that become the first.
  image.layers[0].pixels[0] = 8.5F;
  image.layers[0].pixels[1] = std::nanf("");
  const Thumbnail small = make_thumbnail(image);
  EXPECT_EQ(small.width, 256);
  EXPECT_EQ(small.height, 128);
  ASSERT_EQ(small.pixels.size(), 3U * 256 * 128);
  EXPECT_FLOAT_EQ(small.pixels[0], 1.F);
  EXPECT_FLOAT_EQ(small.pixels[1], 0.5F * 15 / 16);
  EXPECT_FLOAT_EQ(small.pixels[2], 0.5F);
}

TEST(Thumbnail, CoversEveryPixelOfAnOddSize) {
  // Each thumbnail pixel has 1 or 2 source pixels of the same value, so each must have it too.
  const ReportImage image{"odd", 301, 3, {{"", 1, std::vector<float>(903, 2.F)}}, {}, {}};
  const Thumbnail small = make_thumbnail(image);
  EXPECT_EQ(small.width, 256);
  for (const float value : small.pixels) EXPECT_EQ(value, 2.F);
}

TEST(Thumbnail, DoesNotEnlarge) {
  const ReportImage image{"tiny", 2, 1, {{"", 1, {1.F, 3.F}}}, {}, {}};
  const Thumbnail small = make_thumbnail(image);
  EXPECT_EQ(small.width, 2);
  EXPECT_EQ(small.pixels, (std::vector<float>{1, 1, 1, 3, 3, 3}));
}

}  // namespace
}  // namespace ajar
