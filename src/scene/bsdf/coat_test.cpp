#include "scene/bsdf/coat.h"

#include <gtest/gtest.h>

#include "scene/bsdf/bsdf_catalogue.h"

namespace ajar {
namespace {

using testing::direction;

TEST(Coat, MeanTransmittanceIsThatOfFresnel) {
  for (const float eta : {1.2F, 1.5F, 2.4F}) {
    const Coat coat{eta, 0.F};
    double sum = 0.0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      const float cosine = (static_cast<float>(i) + 0.5F) / kSteps;
      sum += static_cast<double>(2.F * cosine * coat.transmittance(cosine)) / kSteps;
    }
    EXPECT_NEAR(coat.mean_transmittance(), sum, 1e-4) << eta;
  }
  // Glass reflects 9.2 % of diffuse light.
  EXPECT_NEAR((Coat{1.5F, 0.F}).mean_transmittance(), 0.908F, 1e-3F);
}

TEST(Coat, OfHardlyAnyRoughnessIsLikeASmoothOne) {
  for (const float cosine : {0.2F, 0.5F, 0.9F}) {
    EXPECT_NEAR((Coat{1.5F, 1e-3F}).transmittance(cosine), (Coat{1.5F, 0.F}).transmittance(cosine),
                5e-3F);
  }
}

TEST(Coat, LetsMoreThroughNearerToTheNormal) {
  for (const float alpha : {0.F, 0.05F, 0.15F, 0.3F, 0.6F, 0.8F, 1.F}) {
    float before = 0.F;
    for (int i = 1; i <= 200; ++i) {
      const float through = Coat{kVarnishIndex, alpha}.transmittance(static_cast<float>(i) / 200.F);
      EXPECT_GE(through, before - 1e-6F) << alpha << " at " << i;
      before = through;
    }
  }
}

TEST(Coat, LetsNoMoreThroughThanItDoesNotReflect) {
  for (const FacetModel model : {FacetModel::Ggx, FacetModel::BeckmannSeparable}) {
    for (const CoatPass pass : {CoatPass::Smooth, CoatPass::Single, CoatPass::Lossy}) {
      for (const float alpha : {0.05F, 0.33F, 1.F}) {
        for (const float eta : {1.1F, 1.55F, 3.F}) {
          const Coat coat(eta, alpha, model, pass);
          for (int i = 1; i <= 50; ++i) {
            const float cosine = static_cast<float>(i) / 50.F;
            EXPECT_LE(coat.transmittance(cosine), 1.F - coat.reflectance(cosine) + 1e-4F)
                << static_cast<int>(pass) << " " << alpha << " " << eta << " " << cosine;
          }
          EXPECT_LE(coat.turned_back(), 1.F - coat.mean_transmittance() / (eta * eta) + 2e-3F);
        }
      }
    }
  }
}

TEST(CoatedDiffuse, WithoutACoatIsLambert) {
  const CoatedDiffuse lobe(Spectrum(0.7F), {1.F, 0.F});
  const Vec3 wo = direction(40.F, 10.F);
  const Vec3 wi = direction(60.F, 200.F);
  const LobeValue v = lobe.evaluate(wo, wi, false, TransportMode::Radiance);
  EXPECT_NEAR(v.value[0], 0.7F * wi.z * kInvPi, 1e-5F);
}

TEST(CoatedDiffuse, MatchesTheSeriesOfReflections) {
  // Through the coat, r, and again after each reflection inside: T T r (1 + r F + r² F² + …) / η².
  const float eta = 1.5F;
  const float r = 0.6F;
  const Coat coat{eta, 0.F};
  const double inside = 1.0 - static_cast<double>(coat.mean_transmittance()) / (1.5 * 1.5);
  double series = 0.0;
  for (int i = 0; i < 100; ++i) series += std::pow(0.6 * inside, i);
  const Vec3 wo = direction(30.F, 0.F);
  const Vec3 wi = direction(70.F, 90.F);
  const double expected = (1 - fresnel_dielectric(wo.z, eta).reflectance) *
                          (1 - fresnel_dielectric(wi.z, eta).reflectance) * 0.6 * series /
                          (M_PI * 1.5 * 1.5) * static_cast<double>(wi.z);
  const LobeValue v =
      CoatedDiffuse(Spectrum(r), coat).evaluate(wo, wi, false, TransportMode::Radiance);
  EXPECT_NEAR(v.value[0], expected, 1e-5);
}

TEST(CoatedDiffuse, WithSoManyBouncesIsThatManyTermsOfTheSeries) {
  const float eta = 1.5F;
  const Coat coat{eta, 0.F};
  const Vec3 wo = direction(30.F, 0.F);
  const Vec3 wi = direction(70.F, 90.F);
  const float once = (1.F - fresnel_dielectric(wo.z, eta).reflectance) *
                     (1.F - fresnel_dielectric(wi.z, eta).reflectance) * 0.6F / (eta * eta);
  const float x = 0.6F * (1.F - coat.mean_transmittance() / (eta * eta));
  const auto value = [&](int bounces) {
    return CoatedDiffuse(Spectrum(0.6F), Coat(eta, 0.F, FacetModel::Ggx, CoatPass::Whole, bounces))
        .evaluate(wo, wi, false, TransportMode::Radiance)
        .value[0];
  };
  EXPECT_NEAR(value(1), once * wi.z * kInvPi, 1e-6F);
  EXPECT_NEAR(value(3), once * (1.F + x + x * x) * wi.z * kInvPi, 1e-6F);
}

TEST(CoatedDiffuse, AbsorbsAlongTheRefractedWays) {
  const float eta = 1.5F;
  const Coat coat{eta, 0.F};
  const Vec3 wo = direction(30.F, 0.F);
  const Vec3 wi = direction(70.F, 90.F);
  const auto value = [&](float depth) {
    return CoatedDiffuse(Spectrum(0.6F), Coat(eta, 0.F, FacetModel::Ggx, CoatPass::Whole, 1),
                         {Spectrum(depth)})
        .evaluate(wo, wi, false, TransportMode::Radiance)
        .value[0];
  };
  const auto inner = [&](const Vec3& w) {
    return std::sqrt(1.F - (1.F - w.z * w.z) / (eta * eta));
  };
  EXPECT_NEAR(value(0.4F) / value(0.F), std::exp(-0.4F / inner(wo) - 0.4F / inner(wi)), 1e-5F);
  // In between, diffuse light crosses the coat twice for each further bounce: 2 E₃ each time.
  const auto all = [&](float depth) {
    return CoatedDiffuse(Spectrum(0.6F), coat, {Spectrum(depth)}).base.lanes[0] * eta * eta / 0.6F;
  };
  double left = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double mu = (i + 0.5) / kSteps;
    left += std::exp(-0.4 / mu) * 2.0 * mu / kSteps;
  }
  const double x =
      0.6 * (1.0 - static_cast<double>(coat.mean_transmittance()) / 2.25) * left * left;
  EXPECT_NEAR(all(0.4F), 1.0 / (1.0 - x), 1e-4);
}

TEST(CoatedDiffuse, WhiteOnesGiveBackAllThatTheCoatLetsThrough) {
  for (const CoatPass pass : {CoatPass::Whole, CoatPass::Smooth, CoatPass::Single}) {
    for (const float alpha : {0.F, 0.3F}) {
      const Coat coat(1.5F, alpha, FacetModel::Ggx, pass);
      const CoatedDiffuse lobe(Spectrum(1.F), coat);
      for (const float theta : {5.F, 45.F, 80.F}) {
        const Vec3 wo = direction(theta, 0.F);
        EXPECT_NEAR(lobe.albedo(wo)[0], coat.transmittance(wo.z), 2e-3F)
            << static_cast<int>(pass) << " " << alpha << " " << theta;
      }
    }
  }
}

TEST(CoatedDiffuse, LosesMoreUnderFacetsThatLose) {
  const auto albedo = [](CoatPass pass) {
    const Coat coat(1.5F, 0.4F, FacetModel::GgxSeparable, pass);
    return CoatedDiffuse(Spectrum(0.5F), coat).albedo(direction(30.F, 0.F))[0];
  };
  EXPECT_LT(albedo(CoatPass::LossySum), albedo(CoatPass::Lossy));
  EXPECT_LT(albedo(CoatPass::Lossy), 0.95F * albedo(CoatPass::Single));
  EXPECT_LT(albedo(CoatPass::Single), 0.95F * albedo(CoatPass::Whole));
}

TEST(CoatedDiffuse, MayAbsorbAsIfItBentNothing) {
  const Vec3 wo = direction(30.F, 0.F);
  const Vec3 wi = direction(70.F, 90.F);
  const auto value = [&](float depth) {
    return CoatedDiffuse(Spectrum(0.6F), {1.5F, 0.F}, {Spectrum(depth), true})
        .evaluate(wo, wi, false, TransportMode::Radiance)
        .value[0];
  };
  EXPECT_NEAR(value(0.4F) / value(0.F), std::exp(-0.4F / wo.z - 0.4F / wi.z), 1e-5F);
}

TEST(Coat, KeepsItsRoughnessInSmallSteps) {
  EXPECT_EQ(sizeof(Coat), 8U);
  // Never smooth by rounding.
  EXPECT_NE(Coat(1.5F, 1e-9F).transmittance(0.3F), Coat(1.5F, 0.F).transmittance(0.3F));
}

TEST(CoatAttenuated, IsAttenuatedByThePartialCoat) {
  const DisneySpecular metal{{FacetModel::GgxSeparable, 0.3F, 0.3F},
                             {PackedSpectrum(Spectrum(0.9F)), 1.F}};
  const Vec3 wo = direction(30.F, 0.F);
  const Vec3 wi = direction(50.F, 170.F);
  // Transmittance at the flatter of the two directions.
  const float through = 1.F - fresnel_dielectric(wi.z, 1.5F).reflectance;
  const LobeValue bare = metal.evaluate(wo, wi, false, TransportMode::Radiance);
  const LobeValue under = CoatAttenuated<DisneySpecular>{metal, {0.F, 0.4F}}.evaluate(
      wo, wi, false, TransportMode::Radiance);
  EXPECT_NEAR(under.value[0], bare.value[0] * (0.6F + 0.4F * through), 1e-5F * bare.value[0]);
  EXPECT_EQ(under.pdf, bare.pdf);
}

TEST(DisneyClearcoat, IsFlatWithoutTheFourCosines) {
  const Vec3 wo = direction(30.F, 0.F);
  const Vec3 wi = direction(50.F, 170.F);
  const auto value = [&](bool flat) {
    return DisneyClearcoat{0.05F, false, flat}
        .evaluate(wo, wi, false, TransportMode::Radiance)
        .value[0];
  };
  EXPECT_NEAR(value(true) / value(false), 4.F * wo.z * wi.z, 1e-4F);
}

TEST(CoatedConductor, SmoothLayersReflectAsPlanesDo) {
  // F + T R T + T R F R T + … = F + T² R / (1 − R F).
  const ConductorFresnel metal(Spectrum(0.2F), Spectrum(2.F));
  const CoatedConductorFresnel both{metal, {1.5F, 0.F}, {}};
  const float cosine = 0.6F;
  const DielectricBoundary boundary = fresnel_dielectric(cosine, 1.5F);
  const float f = boundary.reflectance;
  const float r = metal(boundary.cos_t, true)[0];
  float series = f;
  float inside = (1.F - f) * r;
  for (int i = 0; i < 50; ++i) {
    series += inside * (1.F - f);
    inside *= f * r;
  }
  EXPECT_NEAR(both(cosine, true)[0], series, 1e-5F);
}

TEST(CoatedConductor, HasItsNumberOfBounces) {
  const ConductorFresnel metal(Spectrum(0.2F), Spectrum(2.F));
  const float cosine = 0.6F;
  const DielectricBoundary boundary = fresnel_dielectric(cosine, 1.5F);
  const float f = boundary.reflectance;
  const float r = metal(boundary.cos_t, true)[0];
  const auto value = [&](int bounces) {
    const Coat coat(1.5F, 0.F, FacetModel::Ggx, CoatPass::Whole, bounces);
    return CoatedConductorFresnel{metal, coat, {}}(cosine, true)[0];
  };
  EXPECT_NEAR(value(1), f + (1.F - f) * (1.F - f) * r, 1e-5F);
  EXPECT_NEAR(value(2), f + (1.F - f) * (1.F - f) * r * (1.F + r * f), 1e-5F);
}

/// Share of light from all around that a rough metal under a smooth coat reflects, all in all, by
/// following it between the two.
double reflected_by_layers(const Microfacets& facets, const ConductorFresnel& metal, float eta) {
  const Conductor lobe{facets, metal};
  const Coat coat(eta, 0.F);
  const Vec3 up(0.F, 0.F, 1.F);
  Rng rng(3);
  double sum = 0.0;
  constexpr int kPaths = 60000;
  for (int i = 0; i < kPaths; ++i) {
    const float x = rng.next();
    const Vec3 outside = warp::cosine_hemisphere({x, rng.next()});
    const float through = coat.transmittance(outside.z);
    sum += 1.0 - static_cast<double>(through);
    double left = static_cast<double>(through);
    Vec3 w = coat.inside(outside);
    for (int bounce = 0; bounce < 50; ++bounce) {
      const auto s = lobe.sample(w, testing::random_uniforms(rng), up, TransportMode::Radiance);
      if (!s) break;
      left *= static_cast<double>(s->weight[0]);
      const auto back = static_cast<double>(fresnel_dielectric(s->wi.z, 1.F / eta).reflectance);
      sum += left * (1.0 - back);
      left *= back;
      w = {-s->wi.x, -s->wi.y, s->wi.z};
    }
  }
  return sum / kPaths;
}

TEST(CoatedConductorEcho, CompensatesInternalReflection) {
  const ConductorFresnel metal(Spectrum(0.2F), Spectrum(2.6F));
  const Vec3 up(0.F, 0.F, 1.F);
  for (const float alpha : {0.05F, 0.2F, 0.5F, 0.9F}) {
    const Microfacets facets(FacetModel::Ggx, alpha, alpha);
    Bsdf both(Frame(), up);
    both.add(SmoothCoat{{1.5F}});
    const CoatedConductor first{facets, metal, {1.5F, 0.F}};
    both.add(first);
    both.add(CoatedConductorEcho(first));
    Rng rng(4);
    double sum = 0.0;
    constexpr int kSamples = 60000;
    for (int i = 0; i < kSamples; ++i) {
      const float x = rng.next();
      const Vec3 wo = warp::cosine_hemisphere({x, rng.next()});
      const auto s = both.sample(wo, testing::random_uniforms(rng), TransportMode::Radiance);
      if (s) sum += static_cast<double>(s->weight[0]);
    }
    const double expected = reflected_by_layers(facets, metal, 1.5F);
    EXPECT_NEAR(sum / kSamples, expected, 0.05 * expected) << alpha;
  }
}

TEST(CoatedConductor, IsTheMetalWithoutACoat) {
  const Microfacets facets(FacetModel::Ggx, 0.3F, 0.3F);
  const ConductorFresnel gold({0.143F, 0.375F, 1.442F}, {3.983F, 2.386F, 1.603F});
  const Vec3 wo = direction(30.F, 0.F);
  const Vec3 wi = direction(50.F, 170.F);
  const LobeValue bare = Conductor{facets, gold}.evaluate(wo, wi, false, TransportMode::Radiance);
  const LobeValue coated =
      CoatedConductor{facets, gold, {1.F, 0.F}}.evaluate(wo, wi, false, TransportMode::Radiance);
  EXPECT_NEAR(coated.value[0], bare.value[0], 1e-4F * bare.value[0]);
  EXPECT_NEAR(coated.pdf, bare.pdf, 1e-4F * bare.pdf);
  EXPECT_NEAR(coated.reverse_pdf, bare.reverse_pdf, 1e-4F * bare.reverse_pdf);
}

}  // namespace
}  // namespace ajar
