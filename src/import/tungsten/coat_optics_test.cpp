#include "import/tungsten/coat_optics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ajar::tungsten {
namespace {

TEST(CoatOptics, ReflectancesAreThoseOfTheTables) {
  // d'Eon and Irving 2011, A quantized-diffusion model: fits of the diffuse Fresnel reflectance.
  EXPECT_NEAR(mean_reflectance(1.5), 0.0918, 2e-3);
  EXPECT_NEAR(mean_internal_reflectance(1.5), 0.5963, 2e-3);
  EXPECT_NEAR(mean_reflectance(1.0), 0.0, 1e-12);
  EXPECT_NEAR(mean_internal_reflectance(1.0), 0.0, 1e-12);
}

TEST(CoatOptics, TransmittanceFallsWithTheThickness) {
  EXPECT_NEAR(mean_transmittance(1.5, 0.0), 1.0, 1e-12);
  // 2 E3(1), Abramowitz and Stegun, table 5.4.
  EXPECT_NEAR(mean_transmittance(1.0, 1.0), 2.0 * 0.1096920, 1e-3);
  // Straighter through a denser layer.
  EXPECT_GT(mean_transmittance(2.0, 1.0), mean_transmittance(1.0, 1.0));
  EXPECT_LT(mean_transmittance(2.0, 1.0), std::exp(-1.0));
}

TEST(CoatOptics, RoundTripsLoseWhatTheLayerReflectsTwice) {
  EXPECT_NEAR(mean_round_trip(1.0, 0.0), 1.0, 1e-12);
  EXPECT_LT(mean_round_trip(1.5, 0.0), 1.0 - mean_reflectance(1.5));
  EXPECT_GT(mean_round_trip(1.5, 0.0), 1.0 - 2.0 * mean_reflectance(1.5));
}

TEST(CoatOptics, InvertReflectanceToAnIndex) {
  for (const double ior : {1.1, 1.5, 3.0, 10.0}) {
    EXPECT_NEAR(ior_of_mean_reflectance(mean_reflectance(ior)), ior, 1e-6 * ior);
  }
}

}  // namespace
}  // namespace ajar::tungsten
