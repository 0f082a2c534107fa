#include "scene/bsdf/under_gloss.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/bsdf/bsdf_catalogue.h"
#include "scene/bsdf/disney_specular.h"

namespace ajar {
namespace {

using testing::direction;

/// ∫ value dω_i, by midpoints of cosine-weighted directions.
template <typename L>
double directional_albedo(const L& lobe, const Vec3& wo) {
  constexpr int kPoints = 96;
  double sum = 0.0;
  for (int y = 0; y < kPoints; ++y) {
    for (int x = 0; x < kPoints; ++x) {
      const Vec2 u((static_cast<float>(x) + 0.5F) / kPoints,
                   (static_cast<float>(y) + 0.5F) / kPoints);
      const auto s = lobe.sample(wo, {0.5F, u}, {0.F, 0.F, 1.F}, TransportMode::Radiance);
      if (s) sum += static_cast<double>(s->weight[0]) / (kPoints * kPoints);
    }
  }
  return sum;
}

UnderGloss<SheenOverLambert> base_of(float color, const Gloss& gloss, float sheen = 0.F) {
  return {{Spectrum(color), Spectrum(sheen)}, gloss};
}
DisneySpecular gloss_of(const Gloss& gloss) {
  return {{FacetModel::GgxSeparable, gloss.alpha, gloss.alpha},
          {PackedSpectrum(), 0.F, gloss.eta, gloss.strength}};
}

TEST(UnderGloss, ReflectsWhatAppendixBOfGltfSaysWhereThatIsNoMoreThanAll) {
  // Base 1 and 0.8, roughness 1: closed integrals of the appendix's formulas, of which Fresnel's
  // term is Schlick's. From the middle of a sphere to its edge.
  const Gloss rough{1.5F, 1.F};
  for (const auto& [theta, white, grey] :
       {std::tuple(0.F, 0.972, 0.780), {60.F, 0.974, 0.783}, {87.F, 0.976, 0.788}}) {
    const Vec3 wo = direction(theta, 0.F);
    const double above = directional_albedo(gloss_of(rough), wo);
    EXPECT_NEAR(above + directional_albedo(base_of(1.F, rough), wo), white, 6e-3) << theta;
    EXPECT_NEAR(above + directional_albedo(base_of(0.8F, rough), wo), grey, 6e-3) << theta;
  }
  const Vec3 up(0.F, 0.F, 1.F);
  const Gloss smooth{1.5F, 0.01F};
  EXPECT_NEAR(directional_albedo(base_of(0.8F, smooth), up), 0.8 * 0.96, 2e-3);
}

TEST(UnderGloss, NeverReflectsMoreThanComesIn) {
  for (const float eta : {1.1F, 1.33F, 1.5F, 1.9F, 2.4F, 3.3F}) {
    for (const float alpha : {0.F, 1e-3F, 0.02F, 0.07F, 0.25F, 0.5F, 0.9F, 1.F}) {
      for (const float strength : {0.5F, 1.F}) {
        const Gloss gloss{eta, alpha, strength};
        for (const float theta : {0.F, 30.F, 60.F, 75.F, 82.F, 87.F}) {
          const Vec3 wo = direction(theta, 0.F);
          const double above = directional_albedo(gloss_of(gloss), wo);
          for (const float sheen : {0.F, 1.F}) {
            EXPECT_LE(above + directional_albedo(base_of(1.F, gloss, sheen), wo), 1.005)
                << eta << ' ' << alpha << ' ' << strength << ' ' << theta << ' ' << sheen;
          }
        }
      }
    }
  }
}

TEST(UnderGloss, IsLambertWithoutGloss) {
  const Vec3 wo = direction(40.F, 10.F);
  const Vec3 wi = direction(60.F, 200.F);
  const LobeValue v =
      base_of(0.7F, {1.5F, 0.3F, 0.F}).evaluate(wo, wi, false, TransportMode::Radiance);
  EXPECT_NEAR(v.value[0], 0.7F * wi.z * kInvPi, 1e-6F);
}

TEST(UnderGloss, TransmitsAsMuchAsItReflects) {
  const Gloss gloss{1.5F, 0.3F};
  const UnderGloss<LambertTransmission> sheet{{}, gloss};
  const Vec3 wo = direction(40.F, 10.F);
  const Vec3 wi = direction(60.F, 200.F);
  const Vec3 below(wi.x, wi.y, -wi.z);
  EXPECT_EQ(sheet.evaluate(wo, below, true, TransportMode::Radiance).value,
            base_of(1.F, gloss).evaluate(wo, wi, false, TransportMode::Radiance).value);
}

TEST(MeanSchlickWeight, IsThatOfHalfVectorsOfDiffuseLight) {
  const double theta_o = 75.0 * M_PI / 180;
  double sum = 0.0;
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double theta = (i + 0.5) * M_PI / 2 / kSteps;
      const double phi = (j + 0.5) * M_PI / kSteps;
      const double cosine =
          std::sin(theta) * std::sin(theta_o) * std::cos(phi) + std::cos(theta) * std::cos(theta_o);
      sum += std::pow(1 - std::sqrt((1 + cosine) / 2), 5) * std::sin(2 * theta) * M_PI / 2 /
             (kSteps * kSteps);
    }
  }
  EXPECT_NEAR(mean_schlick_weight(std::cos(75.F * kPi / 180.F)), sum, 1e-3);
}

}  // namespace
}  // namespace ajar
