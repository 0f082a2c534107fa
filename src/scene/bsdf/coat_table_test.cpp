#include "scene/bsdf/coat_table.h"

#include <gtest/gtest.h>

#include "scene/bsdf/bsdf_catalogue.h"

namespace ajar {
namespace {

/// Shares of light that a rough boundary reflects and refracts, by its lobe.
struct Scattered {
  double reflected = 0.0;
  double refracted = 0.0;
};
Scattered scattered(const RoughBoundary& b, const Vec3& wo) {
  const PackedSpectrum white(Spectrum(1.F));
  const RoughDielectric lobe{{b.model, b.alpha, b.alpha}, white, white, b.eta};
  const Vec3 ng(0.F, 0.F, std::copysign(1.F, wo.z));
  Rng rng(5);
  Scattered sum;
  constexpr int kSamples = 40000;
  for (int i = 0; i < kSamples; ++i) {
    const auto s = lobe.sample(wo, testing::random_uniforms(rng), ng, TransportMode::Importance);
    if (s) (s->transmission ? sum.refracted : sum.reflected) += static_cast<double>(s->weight[0]);
  }
  return {sum.reflected / kSamples, sum.refracted / kSamples};
}

constexpr std::array kFacetModels = {FacetModel::Ggx, FacetModel::GgxSeparable,
                                     FacetModel::Beckmann, FacetModel::BeckmannSeparable};
// Off the nodes of the table, too.
constexpr std::array<float, 3> kRoughnesses = {0.1F, 0.37F, 0.9F};

TEST(CoatTable, MatchesTheLobeOfTheBoundary) {
  for (const FacetModel model : kFacetModels) {
    for (const float alpha : kRoughnesses) {
      for (const float eta : {1.33F, 1.55F}) {
        const RoughBoundary boundary{model, eta, alpha};
        for (const float theta : {10.F, 50.F, 75.F}) {
          const Vec3 wo = testing::direction(theta, 30.F);
          const Scattered expected = scattered(boundary, wo);
          EXPECT_NEAR(coat_table::reflected(boundary, wo.z), expected.reflected, 4e-3)
              << static_cast<int>(model) << " " << alpha << " " << eta << " " << theta;
          EXPECT_NEAR(coat_table::refracted(boundary, wo.z), expected.refracted, 6e-3)
              << static_cast<int>(model) << " " << alpha << " " << eta << " " << theta;
        }
      }
    }
  }
}

TEST(CoatTable, MeansAreThoseOfItsRows) {
  for (const FacetModel model : kFacetModels) {
    const RoughBoundary boundary{model, 1.5F, 0.3F};
    double reflected = 0.0;
    double refracted = 0.0;
    constexpr int kSteps = 4000;
    for (int i = 0; i < kSteps; ++i) {
      const float cosine = std::sqrt((static_cast<float>(i) + 0.5F) / kSteps);
      reflected += static_cast<double>(coat_table::reflected(boundary, cosine)) / kSteps;
      refracted += static_cast<double>(coat_table::refracted(boundary, cosine)) / kSteps;
    }
    EXPECT_NEAR(coat_table::mean_reflected(boundary), reflected, 1e-4);
    EXPECT_NEAR(coat_table::mean_refracted(boundary), refracted, 1e-4);
  }
}

TEST(CoatTable, TurnsBackDiffuseLightInsideAsTheLobeDoes) {
  for (const FacetModel model : kFacetModels) {
    for (const float alpha : kRoughnesses) {
      const RoughBoundary boundary{model, 1.5F, alpha};
      double sum = 0.0;
      constexpr int kDirections = 24;
      for (int i = 0; i < kDirections; ++i) {
        const float z = std::sqrt((static_cast<float>(i) + 0.5F) / kDirections);
        sum += scattered(boundary, {std::sqrt(1.F - z * z), 0.F, -z}).reflected;
      }
      const float inside = coat_table::mean_reflected_inside(boundary);
      EXPECT_NEAR(inside, sum / kDirections, 6e-3) << static_cast<int>(model) << " " << alpha;
      // Light that is neither reflected back nor let out, which is as much as comes in
      // (reciprocity), is lost.
      EXPECT_LE(inside, 1.F - coat_table::mean_refracted(boundary) / 2.25F + 1e-3F);
      EXPECT_NEAR(coat_table::sum_reflected_inside(boundary), inside * 63.F / 64.F, 2e-3F);
    }
  }
}

TEST(CoatTable, EndsInASmoothBoundary) {
  const RoughBoundary smooth{FacetModel::Beckmann, 1.4F, 0.F};
  for (const float cosine : {0.3F, 0.6F, 1.F}) {
    const float f = fresnel_dielectric(cosine, 1.4F).reflectance;
    EXPECT_NEAR(coat_table::reflected(smooth, cosine), f, 1e-3F);
    EXPECT_NEAR(coat_table::refracted(smooth, cosine), 1.F - f, 1e-3F);
  }
}

}  // namespace
}  // namespace ajar
