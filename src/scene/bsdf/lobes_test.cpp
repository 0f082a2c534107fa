#include "scene/bsdf/lobes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/bsdf/bsdf_catalogue.h"

namespace ajar {
namespace {
using testing::direction;
using testing::random_uniforms;

constexpr TransportMode kRadiance = TransportMode::Radiance;
constexpr TransportMode kImportance = TransportMode::Importance;
const Vec3 kUp(0.F, 0.F, 1.F);

TEST(OrenNayar, WithoutRoughnessIsLambert) {
  const Vec3 wo = direction(40.F, 10.F);
  const Vec3 wi = direction(70.F, 30.F);
  EXPECT_EQ(OrenNayar(0.F).evaluate(wo, wi, false, kRadiance).value,
            Lambert{}.evaluate(wo, wi, false, kRadiance).value);
}

TEST(OrenNayar, MatchesItsPublishedForm) {
  const double sigma = 0.6;
  const double a = 1 - sigma * sigma / (2 * (sigma * sigma + 0.33));
  const double b = 0.45 * sigma * sigma / (sigma * sigma + 0.09);
  const double to = 50 * kPi / 180;
  const double ti = 35 * kPi / 180;
  const double f = (a + b * std::cos(40 * kPi / 180) * std::sin(to) * std::tan(ti)) / kPi;
  const LobeValue v =
      OrenNayar(0.6F).evaluate(direction(50.F, 60.F), direction(35.F, 20.F), false, kRadiance);
  EXPECT_NEAR(v.value[0], f * std::cos(ti), 1e-6);
}

TEST(FullOrenNayar, MatchesItsPublishedForm) {
  const double variance = 0.5;
  const double c1 = 1 - 0.5 * variance / (variance + 0.33);
  const double narrow = variance / (variance + 0.09);
  const double twice = 0.17 * variance / (variance + 0.13);
  const double ti = 35 * kPi / 180;  // the smaller angle, β
  const double to = 50 * kPi / 180;
  const auto pi_f = [&](double cos_turn) {
    const double r = 2 * ti / kPi;
    const double c2 = 0.45 * narrow * (std::sin(to) - (cos_turn < 0 ? r * r * r : 0));
    const double c3 = 0.125 * narrow * std::pow(4 * to * ti / (kPi * kPi), 2);
    const double single =
        c1 + cos_turn * c2 * std::tan(ti) + (1 - std::abs(cos_turn)) * c3 * std::tan((to + ti) / 2);
    return std::pair(single, twice * (1 - cos_turn * r * r));
  };
  const FullOrenNayar lobe(Spectrum(0.5F, 0.9F, 0.F), std::sqrt(0.5F));
  for (const float turn : {0.F, 60.F, 90.F, 140.F, 180.F}) {
    const auto [single, both] = pi_f(std::cos(static_cast<double>(turn) * kPi / 180));
    const Spectrum value =
        lobe.evaluate(direction(50.F, 20.F + turn), direction(35.F, 20.F), false, kRadiance).value *
        (kPi / std::cos(static_cast<float>(ti)));
    EXPECT_NEAR(value[0], 0.5 * single + 0.25 * both, 1e-5) << turn;
    EXPECT_NEAR(value[1], 0.9 * single + 0.81 * both, 1e-5) << turn;
    EXPECT_EQ(value[2], 0.F);
  }
}

/// G of pbrt-v3 for isotropic GGX in terms of angles.
double ggx_lambda(double theta, double alpha) {
  const double t = alpha * std::tan(theta);
  return (-1 + std::sqrt(1 + t * t)) / 2;
}
double ggx_density(double cos_h, double alpha) {
  const double tan2 = 1 / (cos_h * cos_h) - 1;
  const double e = 1 + tan2 / (alpha * alpha);
  return 1 / (kPi * alpha * alpha * std::pow(cos_h, 4) * e * e);
}

TEST(Conductor, MatchesTorranceAndSparrow) {
  const double alpha = 0.3;
  const Vec3 wo = direction(50.F, 200.F);
  const Vec3 wi = direction(35.F, 20.F);
  const Vec3 h = normalize(wo + wi);
  const ConductorFresnel fresnel(Spectrum(0.2F), Spectrum(3.9F));
  const double g =
      1 / (1 + ggx_lambda(std::acos(wo.z), alpha) + ggx_lambda(std::acos(wi.z), alpha));
  const double f = ggx_density(h.z, alpha) * g * fresnel(dot(wo, h), true)[0] / (4 * wo.z);
  const Conductor lobe{{FacetModel::Ggx, 0.3F, 0.3F}, fresnel};
  EXPECT_NEAR(lobe.evaluate(wo, wi, false, kRadiance).value[0], f, 1e-4 * f);
  EXPECT_NEAR(lobe.evaluate(-wo, -wi, false, kRadiance).value[0], f, 1e-4 * f);
}

TEST(RoughDielectric, TransmissionMatchesWalter) {
  const double alpha = 0.4;
  const Vec3 wo = direction(30.F, 200.F);
  const Vec3 wi = direction(155.F, 40.F);
  const double eta = 1.5;
  const Vec3 h = normalize(-(wo + wi * 1.5F));
  const double oh = dot(wo, h);
  const double ih = dot(wi, h);
  const Vec3 up = h.z > 0.F ? h : -h;
  const double fresnel = fresnel_dielectric(dot(wo, up), 1.5F).reflectance;
  const double g =
      1 / (1 + ggx_lambda(std::acos(wo.z), alpha) + ggx_lambda(std::acos(std::abs(wi.z)), alpha));
  // Walter et al. 2007, eq. 21, for light that arrives along wi and leaves along wo: η_o = 1.
  const double f = std::abs(oh * ih / (wo.z * wi.z)) * (1 - fresnel) * g *
                   ggx_density(up.z, alpha) / ((oh + eta * ih) * (oh + eta * ih));
  const PackedSpectrum white(Spectrum(1.F));
  const RoughDielectric lobe{{FacetModel::Ggx, 0.4F, 0.4F}, white, white, 1.5F};
  EXPECT_NEAR(lobe.evaluate(wo, wi, true, kRadiance).value[0], f * std::abs(wi.z), 1e-4 * f);
  EXPECT_NEAR(lobe.evaluate(wo, wi, true, kImportance).value[0], f * std::abs(wi.z) * eta * eta,
              1e-4 * f);
}

TEST(RoughDielectric, FurnaceLosesOnlyWhatMasksItself) {
  const PackedSpectrum white(Spectrum(1.F));
  Rng rng(21);
  for (const float alpha : {0.01F, 0.1F, 0.3F}) {
    const RoughDielectric lobe{{FacetModel::Ggx, alpha, alpha}, white, white, 1.5F};
    for (const float theta : {5.F, 45.F, 175.F, 150.F}) {
      const Vec3 wo = direction(theta, 0.F);
      double sum = 0.0;
      constexpr int kSamples = 30000;
      for (int k = 0; k < kSamples; ++k) {
        const auto s = lobe.sample(wo, random_uniforms(rng), kUp, kImportance);
        if (s) sum += s->weight[0];
      }
      EXPECT_LE(sum / kSamples, 1.0 + 1e-4);
      EXPECT_GE(sum / kSamples, alpha < 0.2F ? 0.985 : 0.85) << alpha << ' ' << theta;
    }
  }
}

TEST(RoughDielectric, BecomesSmoothGlassAsRoughnessVanishes) {
  const PackedSpectrum white(Spectrum(1.F));
  const RoughDielectric rough{{FacetModel::Ggx, 1e-3F, 1e-3F}, white, white, 1.5F};
  const SmoothDielectric smooth{white, white, 1.5F};
  for (const float theta : {10.F, 60.F, 110.F, 170.F}) {
    const Vec3 wo = direction(theta, 77.F);
    for (const float choice : {0.F, 0.999F}) {
      const BsdfUniforms u{choice, {0.3F, 0.2F}};
      const auto a = rough.sample(wo, u, kUp, kRadiance);
      const auto b = smooth.sample(wo, u, kUp, kRadiance);
      ASSERT_TRUE(a && b);
      EXPECT_LT(length(a->wi - b->wi), 2e-2F);
      EXPECT_NEAR(a->weight[0], b->weight[0], 1e-2F);
      EXPECT_EQ(a->transmission, b->transmission);
      EXPECT_EQ(a->eta, b->eta);
    }
  }
}

TEST(SmoothDielectric, LosesNothing) {
  const PackedSpectrum white(Spectrum(1.F));
  const SmoothDielectric glass{white, white, 1.5F};
  for (const float theta : {3.F, 60.F, 89.F, 100.F, 130.F, 179.F}) {
    const Vec3 wo = direction(theta, 0.F);
    const float f = glass.albedo(wo)[0];
    EXPECT_NEAR(f, 1.F, 1e-6F);
    for (const float u : {0.F, 0.9999F}) {
      const auto s = glass.sample(wo, {u, {0.F, 0.F}}, kUp, kImportance);
      ASSERT_TRUE(s);
      EXPECT_NEAR(s->weight[0], 1.F, 1e-6F);
      EXPECT_FLOAT_EQ(s->pdf, s->reverse_pdf);
    }
  }
}

TEST(SmoothDielectric, ObeysSnellAndScalesRadiance) {
  const PackedSpectrum white(Spectrum(1.F));
  const SmoothDielectric glass{white, white, 1.5F};
  const Vec3 wo = direction(50.F, 30.F);
  const auto s = glass.sample(wo, {0.99F, {0.F, 0.F}}, kUp, kRadiance);
  ASSERT_TRUE(s);
  EXPECT_TRUE(s->transmission);
  EXPECT_FLOAT_EQ(s->eta, 1.5F);
  EXPECT_NEAR(std::hypot(s->wi.x, s->wi.y) * 1.5F, std::hypot(wo.x, wo.y), 1e-6F);
  EXPECT_LT(s->wi.z, 0.F);
  EXPECT_NEAR(s->weight[0], 1.F / 2.25F, 1e-6F);
  const auto back = glass.sample(s->wi, {0.99F, {0.F, 0.F}}, kUp, kRadiance);
  ASSERT_TRUE(back);
  EXPECT_LT(length(back->wi - wo), 1e-6F);
  EXPECT_NEAR(back->weight[0], 2.25F, 1e-5F);
  EXPECT_NEAR(back->eta * s->eta, 1.F, 1e-6F);
}

TEST(ThinDielectric, SumsItsInternalReflections) {
  const PackedSpectrum white(Spectrum(1.F));
  const ThinDielectric pane{white, white, 1.5F};
  const Vec3 wo = direction(60.F, 30.F);
  const double r = fresnel_dielectric(wo.z, 1.5F).reflectance;
  double reflected = r;
  double carried = (1 - r) * (1 - r);
  for (int k = 0; k < 100; ++k) {
    reflected += carried * r;
    carried *= r * r;
  }
  const auto s = pane.sample(wo, {0.F, {0.F, 0.F}}, kUp, kRadiance);
  ASSERT_TRUE(s);
  EXPECT_NEAR(s->pdf, reflected, 1e-5);
  const auto through = pane.sample(wo, {0.999F, {0.F, 0.F}}, kUp, kRadiance);
  ASSERT_TRUE(through);
  EXPECT_LT(length(through->wi + wo), 1e-6F);
  EXPECT_NEAR(through->weight[0], 1.F, 1e-6F);
  EXPECT_EQ(through->eta, 1.F);
}

TEST(ThinDielectric, MayKeepPolarisationsApartAndAbsorbOnTheWay) {
  // At Brewster's angle one polarisation goes through alone, and the angles are complementary.
  const float eta = 1.5F;
  const float cos_i = 1.F / std::sqrt(1.F + eta * eta);
  const float cos_t = std::sqrt(1.F - cos_i * cos_i);
  const float sine = (eta * eta - 1.F) / (eta * eta + 1.F);
  const float perpendicular = sine * sine;
  const Spectrum along(0.5F, 0.25F, 0.F);
  const ThinDielectric pane{PackedSpectrum(Spectrum(1.F)), PackedSpectrum(along), eta, true, true};
  const Vec3 wo(std::sqrt(1.F - cos_i * cos_i), 0.F, cos_i);
  const float reflected = perpendicular / (1.F + perpendicular);
  // cos θt = sin θi there.
  EXPECT_NEAR(cos_t, eta * cos_i, 1e-6F);
  const float way = 1.F / (eta * cos_i);
  const Spectrum albedo = pane.albedo(wo);
  EXPECT_NEAR(albedo[0], reflected + (1.F - reflected) * std::pow(0.5F, way), 1e-6F);
  EXPECT_NEAR(albedo[1], reflected + (1.F - reflected) * std::pow(0.25F, way), 1e-6F);
  EXPECT_NEAR(albedo[2], reflected, 1e-6F);
  const auto through = pane.sample(wo, {0.999F, {0.F, 0.F}}, kUp, kRadiance);
  ASSERT_TRUE(through);
  EXPECT_NEAR(through->weight[0] * through->pdf, (1.F - reflected) * std::pow(0.5F, way), 1e-6F);
}

TEST(SpecularTransmission, IsEmptyUnderTotalReflection) {
  EXPECT_FALSE(SpecularTransmission{1.5F}.sample(direction(130.F, 0.F), {0.5F, {0.5F, 0.5F}}, kUp,
                                                 kRadiance));
}

TEST(FresnelBlend, MatchesAshikhminAndShirley) {
  const double alpha = 0.3;
  const Vec3 wo = direction(50.F, 200.F);
  const Vec3 wi = direction(35.F, 20.F);
  const Vec3 h = normalize(wo + wi);
  const double rd = 0.6;
  const double rs = 0.1;
  const double diffuse = 28 / (23 * kPi) * rd * (1 - rs) * (1 - std::pow(1 - wo.z / 2, 5)) *
                         (1 - std::pow(1 - wi.z / 2, 5));
  const double schlick = rs + std::pow(1 - dot(wi, h), 5) * (1 - rs);
  const double specular =
      ggx_density(h.z, alpha) / (4 * dot(wi, h) * std::max(wo.z, wi.z)) * schlick;
  const FresnelBlend lobe{{FacetModel::Ggx, 0.3F, 0.3F},
                          PackedSpectrum(Spectrum(0.6F)),
                          PackedSpectrum(Spectrum(0.1F))};
  const double expected = (diffuse + specular) * wi.z;
  EXPECT_NEAR(lobe.evaluate(wo, wi, false, kRadiance).value[0], expected, 1e-4 * expected);
}

TEST(DisneyDiffuse, MatchesBurley) {
  const Vec3 wo = direction(50.F, 200.F);
  const Vec3 wi = direction(35.F, 60.F);
  const double cos_d = dot(wi, normalize(wo + wi));
  const double fo = std::pow(1 - wo.z, 5);
  const double fi = std::pow(1 - wi.z, 5);
  const double roughness = 0.7;
  const double rr = 2 * roughness * cos_d * cos_d;
  const double retro = rr * (fo + fi + fo * fi * (rr - 1));
  const double plain = (1 - fo / 2) * (1 - fi / 2);
  const double fss90 = cos_d * cos_d * roughness;
  const double fss = (1 + fo * (fss90 - 1)) * (1 + fi * (fss90 - 1));
  const double flat = 1.25 * (fss * (1 / (wo.z + wi.z) - 0.5) + 0.5);
  const double sheen = 0.3 * std::pow(1 - cos_d, 5);
  using Shares = DisneyDiffuse::Shares;
  for (const Shares& shares :
       {Shares{}, Shares{0.25F, 0.75F, 1.F}, Shares{0.25F, 0.75F, 0.25F}, Shares{0.F, 1.F, 0.F}}) {
    const double f = 0.8 / kPi *
                         (double{shares.plain} * plain + double{shares.flat} * flat +
                          double{shares.retro} * retro) +
                     sheen;
    const DisneyDiffuse lobe{PackedSpectrum(Spectrum(0.8F)), PackedSpectrum(Spectrum(0.3F)), shares,
                             0.7F};
    EXPECT_NEAR(lobe.evaluate(wo, wi, false, kRadiance).value[0], f * wi.z, 1e-5);
  }
}

TEST(SheetTransmission, IsTheReflectionOfItsFacetsOnTheOtherSide) {
  const Microfacets facets(FacetModel::GgxSeparable, 0.3F, 0.5F);
  const Vec3 wo = direction(50.F, 200.F);
  const Vec3 up = direction(35.F, 60.F);
  const Vec3 below(up.x, up.y, -up.z);
  const HalfVector half = half_vector(wo, up);
  const float fresnel = fresnel_dielectric(half.cosine, 1.5F).reflectance;
  const auto masking = [&](const Vec3& w) { return w.z / facets.projected_area(w); };
  const float expected =
      (1.F - fresnel) * facets.density(half.h) * masking(wo) * masking(up) / (4.F * wo.z);
  const SheetTransmission sheet{facets, 1.5F};
  EXPECT_NEAR(sheet.evaluate(wo, below, true, kRadiance).value[0], expected, 1e-5F * expected);
  EXPECT_NEAR(sheet.evaluate(-wo, -below, true, kImportance).value[0], expected, 1e-5F * expected)
      << "the same from behind";
  EXPECT_TRUE(sheet.evaluate(wo, up, false, kRadiance).value.is_black());
  // Nearly smooth ones let light pass straight on.
  const SheetTransmission smooth{Microfacets(FacetModel::Ggx, 1e-3F, 1e-3F), 1.5F};
  const auto s = smooth.sample(wo, {0.5F, {0.3F, 0.3F}}, kUp, kRadiance);
  ASSERT_TRUE(s);
  EXPECT_LT(length(s->wi + wo), 0.01F);
  EXPECT_TRUE(s->transmission);
  EXPECT_EQ(s->eta, 1.F);
}

TEST(DisneyFresnel, IsTheSameFromBehindUnlessThereIsGlass) {
  const DisneyFresnel opaque{PackedSpectrum(Spectrum(0.5F)), 0.5F, 1.5F};
  EXPECT_EQ(opaque(0.4F, true), opaque(0.4F, false));
  const DisneyGlassFresnel glass{opaque, 0.3F};
  EXPECT_EQ(glass(0.4F, true), opaque(0.4F, true));
  EXPECT_EQ(glass(0.4F, false)[0], 0.3F) << "beyond the critical angle";
  EXPECT_NEAR(glass(1.F, false)[0], 0.3F * 0.04F, 1e-6F);
}

TEST(DisneyDiffuse, OfGlassIsBlackFromWithin) {
  const DisneyDiffuse lobe{PackedSpectrum(Spectrum(0.8F)), {}, {}, 0.5F, true};
  const Vec3 wo = direction(50.F, 200.F);
  const Vec3 wi = direction(35.F, 60.F);
  EXPECT_GT(lobe.evaluate(wo, wi, false, kRadiance).value[0], 0.F);
  EXPECT_TRUE(lobe.evaluate(-wo, -wi, false, kRadiance).value.is_black());
  EXPECT_TRUE(lobe.albedo(-wo).is_black());
}

TEST(VisitLobe, ReachesEveryAlternative) {
  EXPECT_TRUE(visit_lobe(Lobe(Mirror{}), [](const auto& l) { return l.kSpecular; }));
  EXPECT_FALSE(visit_lobe(Lobe(Lambert{}), [](const auto& l) { return l.kSpecular; }));
  EXPECT_FALSE(visit_lobe(Lobe(DisneyClearcoat{}), [](const auto& l) { return l.kSpecular; }));
  EXPECT_FLOAT_EQ(visit_lobe(Lobe(SpecularReflection{1.5F}),
                             [](const auto& l) { return l.albedo(Vec3(0.F, 0.F, 1.F))[0]; }),
                  0.04F);
}

}  // namespace
}  // namespace ajar
