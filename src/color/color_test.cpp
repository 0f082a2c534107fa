#include "color/color.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "color/cie_1931.h"

namespace ajar {
namespace {

TEST(Cie1931, IntegralsAreEqualForTheEqualEnergySpectrum) {
  Vec3d sum(0.0, 0.0, 0.0);
  for (const auto& row : kCie1931) sum += Vec3d(row[0], row[1], row[2]) * kCieStep;
  EXPECT_NEAR(sum.x, 106.865, 0.01);
  EXPECT_NEAR(sum.y, 106.857, 0.01);
  EXPECT_NEAR(sum.z, 106.892, 0.01);
}

TEST(Color, ConstantSpectrumHasUnitLuminanceAndTheWhitePointOfIlluminantE) {
  const std::vector<double> wavelengths = {400.0};
  const std::vector<double> values = {1.0};
  const Vec3d xyz = sampled_to_xyz(wavelengths, values);
  EXPECT_NEAR(xyz.y, 1.0, 1e-12);
  EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), 1.0 / 3.0, 2e-4);
  EXPECT_NEAR(xyz.z / (xyz.x + xyz.y + xyz.z), 1.0 / 3.0, 2e-4);
}

TEST(Color, RgbWhiteIsD65) {
  const Vec3d xyz = rgb_to_xyz({1.0, 1.0, 1.0});
  EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), 0.3127, 1e-4);
  EXPECT_NEAR(xyz.y / (xyz.x + xyz.y + xyz.z), 0.3290, 1e-4);
}

TEST(Color, XyzAndRgbAreInverse) {
  const Vec3d rgb(0.2, 0.7, 0.4);
  const Vec3d back = xyz_to_rgb(rgb_to_xyz(rgb));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(back[i], rgb[i], 1e-5);
}

TEST(Color, SampleOrderDoesNotMatter) {
  const std::array<double, 3> up = {400.0, 550.0, 700.0};
  const std::array<double, 3> up_values = {0.1, 0.9, 0.4};
  const std::array<double, 3> down = {700.0, 400.0, 550.0};
  const std::array<double, 3> down_values = {0.4, 0.1, 0.9};
  EXPECT_EQ(sampled_to_rgb(up, up_values), sampled_to_rgb(down, down_values));
}

TEST(Color, RepeatedWavelengthsAreAStep) {
  const std::array<double, 4> wavelengths = {400.0, 550.0, 550.0, 700.0};
  const std::array<double, 4> values = {0.0, 0.0, 1.0, 1.0};
  const Vec3d xyz = sampled_to_xyz(wavelengths, values);
  EXPECT_GT(xyz.y, 0.45);
  EXPECT_LT(xyz.y, 0.6);
  EXPECT_LT(xyz.z, 0.01);
}

TEST(Blackbody, ChromaticitiesLieOnThePlanckianLocus) {
  // Kelly 1963 / CIE 15: chromaticity of Planckian radiators.
  const std::array<std::array<double, 3>, 4> locus = {{{2000.0, 0.5267, 0.4133},
                                                       {3000.0, 0.4369, 0.4041},
                                                       {5000.0, 0.3451, 0.3516},
                                                       {6500.0, 0.3135, 0.3237}}};
  for (const auto& row : locus) {
    const Vec3d xyz = blackbody_xyz(row[0]);
    const double sum = xyz.x + xyz.y + xyz.z;
    EXPECT_NEAR(xyz.x / sum, row[1], 5e-4) << row[0];
    EXPECT_NEAR(xyz.y / sum, row[2], 5e-4) << row[0];
  }
}

TEST(Blackbody, AgreesWithTheColourThatPbrtWroteForTheGlassScene) {
  // pbrt-v3-scenes, caustic-glass: "blackbody I" [5500 125] became "rgb I" in glass.pbrt.
  const Vec3d rgb = blackbody_rgb(5500.0) * 125.0;
  EXPECT_NEAR(rgb.x, 139.8113403320, 0.5);
  EXPECT_NEAR(rgb.y, 118.6366500854, 0.4);
  EXPECT_NEAR(rgb.z, 105.3887557983, 0.4);
}

TEST(Blackbody, ColdBodiesAreRedAndNeverNegative) {
  const Vec3d rgb = blackbody_rgb(900.0);
  EXPECT_GT(rgb.x, 0.0);
  EXPECT_EQ(rgb.z, 0.0);
  EXPECT_EQ(blackbody_rgb(0.0), Vec3d(0.0, 0.0, 0.0));
  EXPECT_EQ(blackbody_rgb(-5.0), Vec3d(0.0, 0.0, 0.0));
}

}  // namespace
}  // namespace ajar
