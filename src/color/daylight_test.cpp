#include "color/daylight.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ajar {
namespace {

constexpr double kDegree = M_PI / 180.0;

double x_of(const Vec3d& xyz) { return xyz.x / (xyz.x + xyz.y + xyz.z); }
double y_of(const Vec3d& xyz) { return xyz.y / (xyz.x + xyz.y + xyz.z); }

TEST(ClearSky, HasTheZenithOfItsPolynomials) {
  // The sun in the zenith: only the constants remain, χ = (4/9 − T/120) π. By hand for T = 2:
  const Vec3d high = ClearSky(2.0, 0.0).luminance(0.0, 0.0);
  EXPECT_NEAR(high.y, 3.1196 * std::tan(77.0 * kDegree) + 1.9882, 1e-9);
  EXPECT_NEAR(x_of(high), 0.25886 + 2.0 * 0.00394, 1e-9);
  EXPECT_NEAR(y_of(high), 0.26688 + 2.0 * 0.00516, 1e-9);
  // On the horizon χ = 0: the luminance is that of the last terms, and θ = π/2 in the polynomials.
  const double s = M_PI / 2.0;
  const Vec3d low = ClearSky(4.0, s).luminance(0.0, s);
  EXPECT_NEAR(low.y, 2.4192 - 4.0 * 0.2155, 1e-9);
  EXPECT_NEAR(x_of(low),
              16.0 * (0.00166 * s * s * s - 0.00375 * s * s + 0.00209 * s) +
                  4.0 * (-0.02903 * s * s * s + 0.06377 * s * s - 0.03202 * s + 0.00394) +
                  0.11693 * s * s * s - 0.21196 * s * s + 0.06052 * s + 0.25886,
              1e-9);
}

TEST(ClearSky, IsDistributedByPerezFromTheZenith) {
  // Y, T = 3: A = -0.9269, B = -0.6387, C = 5.2570, D = -2.2153, E = 0.1693.
  const double sun = 40.0 * kDegree;
  const ClearSky sky(3.0, sun);
  const auto f = [](double zenith, double from_sun) {
    return (1.0 - 0.9269 * std::exp(-0.6387 / std::cos(zenith))) *
           (1.0 + 5.2570 * std::exp(-2.2153 * from_sun) +
            0.1693 * std::cos(from_sun) * std::cos(from_sun));
  };
  const double zenith = 70.0 * kDegree;
  const double from_sun = 30.0 * kDegree;
  EXPECT_NEAR(sky.luminance(zenith, from_sun).y / sky.luminance(0.0, sun).y,
              f(zenith, from_sun) / f(0.0, sun), 1e-9);
}

TEST(ClearSky, IsBlueAndBrightestAroundTheSun) {
  const double sun = 50.0 * kDegree;
  const ClearSky sky(2.5, sun);
  // 90° from the sun and in front of it. D65 is at 0.3127, 0.3290; bluer is less of both.
  const Vec3d away = sky.luminance(40.0 * kDegree, 90.0 * kDegree);
  EXPECT_LT(x_of(away), 0.27);
  EXPECT_LT(y_of(away), 0.29);
  EXPECT_GT(sky.luminance(sun, 0.0).y, 4.0 * away.y);
  for (int zenith = 0; zenith < 90; zenith += 3) {
    for (int from_sun = 0; from_sun <= 180; from_sun += 3) {
      const Vec3d xyz = sky.luminance(zenith * kDegree, from_sun * kDegree);
      EXPECT_TRUE(xyz.x > 0.0 && xyz.y > 0.0 && xyz.z > 0.0) << zenith << " " << from_sun;
    }
  }
}

TEST(Sun, IsAsBrightAsMeasured) {
  // Darula, Kittler and Gueymard 2005: 133.8 klx before the atmosphere, of which a clear one leaves
  // about 0.8 in the zenith.
  const double high = sun_illuminance(2.0, 0.0).y;
  EXPECT_GT(high, 95.0);
  EXPECT_LT(high, 118.0);
  // Ten times the air at 6 degrees: reddened, and a small part of it.
  const Vec3d low = sun_illuminance(2.0, 84.0 * kDegree);
  EXPECT_LT(low.y, 0.35 * high);
  EXPECT_GT(x_of(low), x_of(sun_illuminance(2.0, 0.0)) + 0.05);
  // Haze takes away: exp(−m Δβ λ^−1.3) with Δβ = 4 · 0.04608 is 0.67 at 555 nm.
  EXPECT_NEAR(
      sun_illuminance(6.0, 0.0).y / high,
      std::exp(-4.0 * 0.04608 * std::pow(0.56, -1.3) / (1.0 + 0.15 * std::pow(93.885, -1.253))),
      0.01);
}

}  // namespace
}  // namespace ajar
