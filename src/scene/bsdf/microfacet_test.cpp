#include "scene/bsdf/microfacet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "scene/bsdf/bsdf_catalogue.h"

namespace ajar {
namespace {

/// ∫ f(h) dh over the upper hemisphere; fine near the normal, where D peaks.
double integrate_hemisphere(const std::function<double(const Vec3&)>& f) {
  constexpr int kThetas = 2000;
  constexpr int kPhis = 200;
  double sum = 0.0;
  for (int a = 0; a < kThetas; ++a) {
    const double x = (a + 0.5) / kThetas;
    const double theta = 0.5 * kPi * x * x;
    const double measure = 0.5 * kPi * 2.0 * x / kThetas * std::sin(theta) * 2.0 * kPi / kPhis;
    for (int b = 0; b < kPhis; ++b) {
      const double phi = 2.0 * kPi * (b + 0.5) / kPhis;
      sum += measure * f(Vec3(static_cast<float>(std::sin(theta) * std::cos(phi)),
                              static_cast<float>(std::sin(theta) * std::sin(phi)),
                              static_cast<float>(std::cos(theta))));
    }
  }
  return sum;
}

const Microfacets kAll[] = {
    {FacetModel::Ggx, 0.05F, 0.05F},    {FacetModel::Ggx, 0.3F, 0.3F},
    {FacetModel::Ggx, 0.2F, 0.8F},      {FacetModel::Beckmann, 0.05F, 0.05F},
    {FacetModel::Beckmann, 0.3F, 0.3F}, {FacetModel::Beckmann, 0.6F, 0.15F}};

TEST(Microfacets, ProjectedAreaIsNormalised) {
  for (const Microfacets& facets : kAll) {
    EXPECT_NEAR(integrate_hemisphere([&](const Vec3& h) { return facets.density(h) * h.z; }), 1.0,
                2e-3);
  }
}

TEST(Microfacets, VisibleNormalsAreNormalised) {
  // Definition of masking: the facets that can be seen project to the area of the surface.
  for (const Microfacets& facets : kAll) {
    for (const float theta : {0.F, 30.F, 70.F, 85.F}) {
      const Vec3 w = testing::direction(theta, 40.F);
      const double visible = integrate_hemisphere(
          [&](const Vec3& h) { return facets.density(h) * std::max(0.F, dot(w, h)); });
      EXPECT_NEAR(visible / facets.projected_area(w), 1.0, 3e-3) << theta;
    }
  }
}

TEST(Microfacets, HeightCorrelatedMaskingLiesBetweenSeparableAndEitherAlone) {
  for (const Microfacets& facets : kAll) {
    const Vec3 a = testing::direction(60.F, 10.F);
    const Vec3 b = testing::direction(75.F, 100.F);
    const float area_a = facets.projected_area(a);
    const float area_b = facets.projected_area(b);
    const float g = facets.shadowing_over_cosines(a.z, area_a, b.z, area_b) * a.z * b.z;
    const float g1a = a.z / area_a;
    const float g1b = b.z / area_b;
    EXPECT_GE(g, g1a * g1b * 0.9999F);
    EXPECT_LE(g, std::min(g1a, g1b) * 1.0001F);
    // pbrt-v3's form.
    EXPECT_NEAR(g, 1.F / (1.F + (1.F / g1a - 1.F) + (1.F / g1b - 1.F)), 1e-5F);
  }
}

TEST(Microfacets, RoughnessIsClampedToSaneValues) {
  const Microfacets facets(FacetModel::Ggx, 0.F, std::nanf(""));
  EXPECT_EQ(facets.alpha_x(), Microfacets::kMinAlpha);
  EXPECT_EQ(facets.alpha_y(), Microfacets::kMinAlpha);
}

TEST(Microfacets, InverseErfInvertsErf) {
  for (int i = -333; i <= 333; ++i) {
    const float x = 0.003F * static_cast<float>(i);
    EXPECT_NEAR(std::erf(inverse_erf(x)), x, 1e-6F);
  }
}

TEST(Microfacets, RoughnessMapsAsInPbrt) {
  EXPECT_NEAR(roughness_to_alpha(1.F), 1.62142F, 1e-5F);
  // The polynomial in double precision.
  const double x = std::log(0.1);
  EXPECT_NEAR(
      roughness_to_alpha(0.1F),
      1.62142 + 0.819955 * x + 0.1734 * x * x + 0.0171201 * x * x * x + 0.000640711 * x * x * x * x,
      1e-5);
  EXPECT_EQ(roughness_to_alpha(0.F), roughness_to_alpha(1e-3F));
  EXPECT_TRUE(std::isfinite(roughness_to_alpha(std::nanf(""))));
}

}  // namespace
}  // namespace ajar
