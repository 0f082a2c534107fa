#include "post/density_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ajar {
namespace {

/// CIELAB lightness of linear sRGB: another space than the one the map is made in.
double lightness(const Spectrum& color) {
  const double y =
      0.2126 * double{color[0]} + 0.7152 * double{color[1]} + 0.0722 * double{color[2]};
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(DensityColor, IsInTheGamutAndGetsEvenlyLighter) {
  double before = lightness(density_color(0.F));
  for (int i = 0; i <= 64; ++i) {
    const Spectrum color = density_color(static_cast<float>(i) / 64.F);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_GE(color[c], 0.F);
      EXPECT_LE(color[c], 1.F);
    }
    if (i == 0) continue;
    const double step = lightness(color) - before;
    EXPECT_GT(step, 0.8) << i;
    EXPECT_LT(step, 1.6) << i;
    before = lightness(color);
  }
}

TEST(DensityMap, ShowsOneInTheMiddleOfItsScaleBesideALegend) {
  const std::vector<float> visits = {1.F, 0.F, 16.F, 1000.F, 0.0625F, 0.5F};
  const DensityMap map = draw_density_map(visits, {3, 2});
  ASSERT_GT(map.size.x, 3);
  ASSERT_GE(map.size.y, 2);
  ASSERT_EQ(map.rgb.size(), 3U * static_cast<std::size_t>(map.size.x * map.size.y));
  const auto at = [&](int x, int y) {
    const auto i = 3 * static_cast<std::size_t>(y * map.size.x + x);
    return Spectrum(map.rgb[i], map.rgb[i + 1], map.rgb[i + 2]);
  };
  EXPECT_EQ(at(0, 0), density_color(0.5F));
  EXPECT_EQ(at(1, 0), Spectrum(0.F));
  EXPECT_EQ(at(2, 0), density_color(1.F));
  EXPECT_EQ(at(0, 1), density_color(1.F)) << "as far as the scale goes";
  EXPECT_EQ(at(1, 1), density_color(0.F));
  EXPECT_EQ(at(2, 1), density_color(0.375F));
  // The bar begins four pixels to the right of the map, and black digits stand beside it.
  EXPECT_EQ(at(7, 0), density_color(1.F));
  EXPECT_EQ(at(7, map.size.y - 1), density_color(0.F));
  int black = 0;
  for (int y = 0; y < map.size.y; ++y) {
    for (int x = 20; x < map.size.x; ++x) black += at(x, y) == Spectrum(0.F) ? 1 : 0;
  }
  EXPECT_GT(black, 50);
}

}  // namespace
}  // namespace ajar
