#include "scene/bsdf/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ajar {
namespace {

TEST(DielectricFresnel, HasKnownValues) {
  EXPECT_NEAR(fresnel_dielectric(1.F, 1.5F).reflectance, 0.04F, 1e-6F);
  EXPECT_NEAR(fresnel_dielectric(1.F, 1.F / 1.5F).reflectance, 0.04F, 1e-6F);
  EXPECT_NEAR(fresnel_dielectric(1e-6F, 1.5F).reflectance, 1.F, 1e-4F);
  EXPECT_EQ(fresnel_dielectric(0.3F, 1.F).reflectance, 0.F);
}

TEST(DielectricFresnel, HalvesAtBrewstersAngle) {
  // There the parallel part vanishes: F is half of the perpendicular part.
  const double brewster = std::atan(1.5);
  const double perpendicular = std::sin(brewster - (kPi / 2 - brewster));
  EXPECT_NEAR(fresnel_dielectric(static_cast<float>(std::cos(brewster)), 1.5F).reflectance,
              0.5 * perpendicular * perpendicular, 1e-6);
}

TEST(DielectricFresnel, IsTotalBeyondTheCriticalAngle) {
  const float critical = std::asin(1.F / 1.5F);
  EXPECT_EQ(fresnel_dielectric(std::cos(critical + 1e-3F), 1.F / 1.5F).reflectance, 1.F);
  EXPECT_LT(fresnel_dielectric(std::cos(critical - 1e-3F), 1.F / 1.5F).reflectance, 0.9F);
}

TEST(DielectricFresnel, IsTheSameFromBothSides) {
  for (int i = 1; i < 50; ++i) {
    const float cosine = 0.02F * static_cast<float>(i);
    const DielectricBoundary there = fresnel_dielectric(cosine, 1.7F);
    const DielectricBoundary back = fresnel_dielectric(there.cos_t, 1.F / 1.7F);
    EXPECT_NEAR(there.reflectance, back.reflectance, 1e-5F);
    EXPECT_NEAR(back.cos_t, cosine, 1e-5F);
  }
}

TEST(ConductorFresnel, HasKnownValuesAtNormalIncidence) {
  const auto normal = [](double eta, double k) {
    return ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
  };
  const Spectrum gold =
      ConductorFresnel({0.143F, 0.375F, 1.442F}, {3.983F, 2.386F, 1.603F})(1.F, true);
  EXPECT_NEAR(gold[0], normal(0.143, 3.983), 1e-5);
  EXPECT_NEAR(gold[1], normal(0.375, 2.386), 1e-5);
  EXPECT_NEAR(gold[2], normal(1.442, 1.603), 1e-5);
  const Spectrum copper = ConductorFresnel({0.200438F, 0.924033F, 1.102212F},
                                           {3.912949F, 2.452848F, 2.142188F})(1.F, true);
  EXPECT_NEAR(copper[0], 0.9529, 1e-3);
  EXPECT_NEAR(copper[1], 0.6196, 1e-2);
  EXPECT_NEAR(copper[2], 0.5112, 1e-2);
}

TEST(ConductorFresnel, WithoutAbsorptionIsADielectric) {
  const ConductorFresnel glass(Spectrum(1.5F), Spectrum(0.F));
  for (int i = 1; i <= 20; ++i) {
    const float cosine = 0.05F * static_cast<float>(i);
    EXPECT_NEAR(glass(cosine, true)[1], fresnel_dielectric(cosine, 1.5F).reflectance, 2e-5F);
  }
}

TEST(ConductorFresnel, ReflectsAllAtGrazingIncidence) {
  const ConductorFresnel gold({0.143F, 0.375F, 1.442F}, {3.983F, 2.386F, 1.603F});
  EXPECT_NEAR(gold(0.F, true)[2], 1.F, 1e-6F);
}

}  // namespace
}  // namespace ajar
