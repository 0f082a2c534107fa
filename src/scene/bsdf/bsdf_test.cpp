#include "scene/bsdf/bsdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene/bsdf/bsdf_catalogue.h"

namespace ajar {
namespace {
using testing::catalogue;
using testing::direction;
using testing::NamedBsdf;
using testing::random_direction;
using testing::random_uniforms;

constexpr Vec3 kZenith(0.F, 0.F, 1.F);

TEST(Bsdf, IsSmallAndCopiesAsBytes) {
  EXPECT_TRUE(std::is_trivially_copyable_v<Bsdf>);
  EXPECT_LE(sizeof(Bsdf), 640U);
  EXPECT_TRUE(Bsdf().empty());
  EXPECT_FALSE(Bsdf().connectible());
  EXPECT_FALSE(Bsdf().sample(kZenith, {0.5F, {0.5F, 0.5F}}, TransportMode::Radiance));
}

TEST(Bsdf, IgnoresBlackLobesAndLobesBeyondTheLimit) {
  Bsdf bsdf(Frame(), kZenith);
  bsdf.add(Lambert{}, Spectrum(0.F));
  EXPECT_TRUE(bsdf.empty());
  for (int k = 0; k < 20; ++k) bsdf.add(Lambert{}, Spectrum(0.1F));
  EXPECT_NEAR(bsdf.albedo(kZenith)[0], 0.1F * Bsdf::kMaxLobes, 1e-5F);
}

TEST(Bsdf, OfNegligibleWeightScattersNothing) {
  Bsdf bsdf(Frame(), Vec3(0.F, 0.F, 1.F));
  bsdf.add(Lambert{}, Spectrum(1e-40F));
  bsdf.add(Mirror{}, Spectrum(1e-40F));
  bsdf.add(RoughCoat{Microfacets(FacetModel::Ggx, 0.2F, 0.2F), {1.F}});
  const Vec3 wo = direction(40.F, 10.F);
  EXPECT_EQ(bsdf.pdf(wo, direction(70.F, 30.F)).value(), 0.F);
  EXPECT_FALSE(bsdf.sample(wo, {0.5F, {0.3F, 0.7F}}, TransportMode::Radiance));
}

TEST(Bsdf, AdjointPairsAgree) {
  // eval(a, b, Importance) |a·ng| = eval(b, a, Radiance) |b·ng|, refraction and tilted normals
  // included.
  Rng rng(11);
  for (const float tilt : {0.F, 20.F, 50.F}) {
    for (const NamedBsdf& b : catalogue(tilt)) {
      int compared = 0;
      for (int k = 0; k < 4000; ++k) {
        const Vec3 x = random_direction(rng);
        const Vec3 y = random_direction(rng);
        const Spectrum left = b.bsdf.eval(x, y, TransportMode::Importance) * std::abs(x.z);
        const Spectrum right = b.bsdf.eval(y, x, TransportMode::Radiance) * std::abs(y.z);
        compared += !left.is_black();
        for (int lane = 0; lane < 3; ++lane) {
          EXPECT_NEAR(left[lane], right[lane], 2e-3F * (left[lane] + right[lane]) + 1e-6F)
              << b.name << x << y;
        }
      }
      if (b.bsdf.connectible()) {
        EXPECT_GT(compared, 100) << b.name;
      }
    }
  }
}

TEST(Bsdf, AdjointPairsOfSpecularLobesAgree) {
  Rng rng(12);
  for (const float tilt : {0.F, 25.F}) {
    for (const NamedBsdf& b : catalogue(tilt)) {
      for (int k = 0; k < 2000; ++k) {
        const Vec3 x = random_direction(rng);
        const auto s = b.bsdf.sample(x, random_uniforms(rng), TransportMode::Importance);
        if (!s || !s->pdf.discrete()) continue;
        // The way back: by the same lobe, which a few tries will find.
        for (int attempt = 0; attempt < 50; ++attempt) {
          const auto back = b.bsdf.sample(s->wi, random_uniforms(rng), TransportMode::Radiance);
          if (!back || !back->pdf.discrete() || length(back->wi - x) > 1e-5F ||
              std::abs(back->eta * s->eta - 1.F) > 1e-4F) {
            continue;
          }
          const float forward_cosines = std::abs(dot(x, kZenith) * dot(s->wi, b.bsdf.ns()));
          const float backward_cosines = std::abs(dot(s->wi, kZenith) * dot(x, b.bsdf.ns()));
          const Spectrum left = s->weight * (s->pdf.value() * s->eta * s->eta * forward_cosines);
          const Spectrum right = back->weight * (back->pdf.value() * backward_cosines);
          EXPECT_NEAR(left[0], right[0], 5e-3F * left[0] + 1e-5F) << b.name << x << s->wi;
          EXPECT_NEAR(back->pdf.value(), s->reverse_pdf.value(), 1e-3F) << b.name;
          break;
        }
      }
    }
  }
}

TEST(Bsdf, ReflectsAndTransmitsNoMoreThanItGets) {
  // Mean weight of samples = directional albedo. In mode Importance, where refraction does not
  // compress radiance, it may not exceed 1.
  Rng rng(13);
  for (const NamedBsdf& b : catalogue(0.F)) {
    if (!b.conserves_energy) continue;
    for (const float theta : {0.5F, 30.F, 60.F, 85.F, 89.F, 95.F, 130.F, 178.F}) {
      const Vec3 wo = direction(theta, 123.F);
      double sum = 0.0;
      double squares = 0.0;
      constexpr int kSamples = 20000;
      for (int k = 0; k < kSamples; ++k) {
        const auto s = b.bsdf.sample(wo, random_uniforms(rng), TransportMode::Importance);
        const double w = s ? s->weight.max() : 0.0;
        sum += w;
        squares += w * w;
      }
      const double mean = sum / kSamples;
      const double sigma = std::sqrt(std::max(0.0, squares / kSamples - mean * mean) / kSamples);
      EXPECT_LE(mean, 1.0 + 5.0 * sigma + 1e-5) << b.name << ", theta " << theta;
    }
  }
}

TEST(Bsdf, LeaksNoLightThroughTiltedNormals) {
  Rng rng(14);
  for (const NamedBsdf& b : catalogue(60.F)) {
    Bsdf opaque(b.bsdf.frame(), kZenith);
    opaque.add(Lambert{});
    opaque.add(Conductor{{FacetModel::Ggx, 0.5F, 0.5F}, {Spectrum(0.2F), Spectrum(3.F)}});
    Bsdf curtain(b.bsdf.frame(), kZenith);
    curtain.add(LambertTransmission{});
    for (int k = 0; k < 1000; ++k) {
      const Vec3 wo = random_direction(rng);
      const Vec3 wi = random_direction(rng);
      const bool through = wo.z * wi.z < 0.F;
      const Bsdf& wrong = through ? opaque : curtain;
      EXPECT_TRUE(wrong.eval(wo, wi, TransportMode::Radiance).is_black());
      EXPECT_EQ(wrong.pdf(wo, wi).value(), 0.F);
      const auto s = b.bsdf.sample(wo, random_uniforms(rng), TransportMode::Importance);
      if (s) {
        EXPECT_EQ(s->transmission, wo.z * s->wi.z < 0.F) << b.name;
      }
    }
  }
}

TEST(Bsdf, DiffuseLobesAreNotBlackBehindTheShadingNormal) {
  Bsdf bsdf(testing::tilted_frame(40.F), kZenith);
  bsdf.add(Lambert{});
  const Vec3 wo = normalize(Vec3(-0.8F, -0.6F, 0.3F));
  ASSERT_LT(dot(wo, bsdf.ns()), 0.F);
  const auto s = bsdf.sample(wo, {0.5F, {0.3F, 0.6F}}, TransportMode::Radiance);
  ASSERT_TRUE(s);
  EXPECT_FLOAT_EQ(s->weight[0], 1.F);
  EXPECT_GT(s->wi.z, 0.F);
}

float extreme(Rng& rng, float low, float high) {
  const float pick = rng.next();
  if (pick < 0.1F) return low;
  if (pick < 0.2F) return high;
  if (pick < 0.6F) return low + (high - low) * rng.next();
  return low * std::pow(high / low, rng.next());
}

Spectrum random_color(Rng& rng) {
  const auto lane = [&] { return rng.next() < 0.2F ? 0.F : rng.next() < 0.2F ? 1.F : rng.next(); };
  const float r = lane();
  const float g = lane();
  return {r, g, lane()};
}

Lobe random_lobe(Rng& rng) {
  const float pick = rng.next();
  const FacetModel model = pick < 0.33F   ? FacetModel::Ggx
                           : pick < 0.67F ? FacetModel::Beckmann
                                          : FacetModel::GgxSeparable;
  const float alpha = extreme(rng, 1e-5F, 3.F);
  const Microfacets facets(model, alpha, rng.next() < 0.5F ? alpha : extreme(rng, 1e-5F, 3.F));
  const PackedSpectrum a(random_color(rng));
  const PackedSpectrum b(random_color(rng));
  const float eta = extreme(rng, 0.05F, 20.F);
  const float rough_eta = std::abs(eta - 1.F) < 1e-3F ? 1.5F : eta;
  const ConductorFresnel metal(Spectrum(extreme(rng, 1e-5F, 1e5F)),
                               Spectrum(extreme(rng, 1e-9F, 1e5F)));
  const float coat_eta = extreme(rng, 1.F, 20.F);
  const auto pass = static_cast<CoatPass>(rng.next() * 5.F);
  const float coat_alpha = rng.next() < 0.5F ? 0.F : alpha;
  const Coat coat(coat_eta, coat_alpha, model, pass, static_cast<int>(rng.next() * 3.F));
  constexpr std::size_t kLobes = std::variant_size_v<Lobe>;
  static_assert(kLobes == 29, "each lobe has a case here");
  switch (static_cast<int>(rng.next() * static_cast<float>(kLobes))) {
    case 0:
      return Lambert{};
    case 1:
      return SmoothDielectric{a, b, eta};
    case 2:
      return Conductor{facets, metal};
    case 3:
      return DielectricReflection{facets, {eta}};
    case 4:
      return FresnelBlend{facets, a, b};
    case 5:
      return RoughDielectric{facets, a, b, rough_eta};
    case 6:
      return Mirror{};
    case 7:
      return PassThrough{};
    case 8:
      return OrenNayar(extreme(rng, 1e-4F, kPi / 2.F));
    case 9:
      return LambertTransmission{};
    case 10:
      return ThinDielectric{a, b, eta};
    case 11:
      return SpecularReflection{eta};
    case 12:
      return SpecularTransmission{eta};
    case 13:
      return DisneyDiffuse{
          a, b, {rng.next(), rng.next(), rng.next()}, rng.next(), rng.next() < 0.5F};
    case 14:
      return DisneySpecular{facets, {a, rng.next(), eta, rng.next()}};
    case 15:
      return DisneyClearcoat{extreme(rng, 0.001F, 0.1F), rng.next() < 0.5F, rng.next() < 0.5F};
    case 16:
      return SmoothConductor{metal};
    case 17:
      return SmoothCoat{{coat_eta}};
    case 18:
      return RoughCoat{facets, {coat_eta}};
    case 19:
      return CoatedDiffuse(a.unpack(), coat, {b.unpack(), rng.next() < 0.5F});
    case 20:
      return CoatedConductor{facets, metal, coat};
    case 21:
      return CoatAttenuated<UnderGloss<SheenOverLambert>>{
          {{a.unpack(), b.unpack()}, {std::max(eta, 1.F), alpha, rng.next()}},
          {coat_alpha, rng.next()}};
    case 22:
      return CoatAttenuated<DisneySpecular>{{facets, {a, rng.next(), eta}},
                                            {coat_alpha, rng.next()}};
    case 23:
      return CoatAttenuated<UnderGloss<LambertTransmission>>{
          {{}, {std::max(eta, 1.F), alpha, rng.next()}}, {coat_alpha, rng.next()}};
    case 24:
      return FullOrenNayar(a.unpack(), extreme(rng, 1e-4F, kPi / 2.F));
    case 25:
      return SheetTransmission{facets, eta};
    case 26:
      return DisneyGlassSpecular{facets, {{a, rng.next(), eta, rng.next()}, rng.next()}};
    case 27:
      return CoatedConductorEcho(CoatedConductor{facets, metal, coat});
    default:
      return SmoothCoatedConductor{{metal, {coat_eta, 0.F}, {}}};
  }
}

/// Directions as they come: random, along axes, and close to the horizon on either side.
Vec3 random_hard_direction(Rng& rng) {
  const float pick = rng.next();
  if (pick < 0.6F) return random_direction(rng);
  if (pick < 0.65F) return {0.F, 0.F, rng.next() < 0.5F ? 1.F : -1.F};
  if (pick < 0.7F) return {1.F, 0.F, 0.F};
  const float z = extreme(rng, 1e-9F, 1e-2F) * (rng.next() < 0.5F ? 1.F : -1.F);
  const float phi = 2.F * kPi * rng.next();
  return normalize(Vec3(std::cos(phi), std::sin(phi), z));
}

TEST(Bsdf, StaysFiniteForAnyParametersAndDirections) {
  Rng rng(15);
  const auto edge = [&](float u) {
    const float pick = rng.next();
    return pick < 0.05F ? 0.F : pick < 0.1F ? kOneMinusEpsilon : u;
  };
  int scattered = 0;
  constexpr int kTrials = 300000;
  for (int k = 0; k < kTrials; ++k) {
    const Vec3 ng = random_direction(rng);
    const Vec3 ns = rng.next() < 0.5F ? ng : face_forward(random_hard_direction(rng), ng);
    Bsdf bsdf(Frame::around(ns), ng);
    const int lobes = 1 + static_cast<int>(rng.next() * 3.F);
    for (int l = 0; l < lobes; ++l) {
      const Spectrum scale = rng.next() < 0.3F ? Spectrum(1.F) : random_color(rng);
      visit_lobe(random_lobe(rng), [&](const auto& lobe) { bsdf.add(lobe, scale); });
    }
    const Vec3 wo = rng.next() < 0.5F ? random_hard_direction(rng)
                                      : Frame::around(ng).to_world(random_hard_direction(rng));
    const TransportMode mode =
        rng.next() < 0.5F ? TransportMode::Radiance : TransportMode::Importance;
    const BsdfUniforms raw = random_uniforms(rng);
    const BsdfUniforms u{edge(raw.lobe), {edge(raw.direction.x), edge(raw.direction.y)}};
    const auto s = bsdf.sample(wo, u, mode);
    const Vec3 wi = s && rng.next() < 0.5F ? s->wi : random_hard_direction(rng);
    const Spectrum value = bsdf.eval(wo, wi, mode);
    const float pdf = bsdf.pdf(wo, wi).value();
    ASSERT_TRUE(value.is_finite() && value.min() >= 0.F) << "trial " << k;
    ASSERT_TRUE(std::isfinite(pdf) && pdf >= 0.F) << "trial " << k;
    // A direction that light takes but `sample` cannot find would darken path tracing.
    ASSERT_TRUE(pdf > 0.F || value.max() <= 1e-30F) << "trial " << k << " value " << value.max();
    const Spectrum albedo = bsdf.albedo(wo);
    ASSERT_TRUE(albedo.is_finite() && albedo.min() >= 0.F) << "trial " << k;
    if (!s) continue;
    ++scattered;
    ASSERT_TRUE(s->weight.is_finite() && s->weight.min() >= 0.F) << "trial " << k;
    ASSERT_TRUE(std::isfinite(s->pdf.value()) && s->pdf.value() > 0.F) << "trial " << k;
    ASSERT_TRUE(std::isfinite(s->reverse_pdf.value()) && s->reverse_pdf.value() >= 0.F) << k;
    ASSERT_NEAR(length(s->wi), 1.F, 1e-4F) << "trial " << k;
    ASSERT_TRUE(std::isfinite(s->eta) && s->eta > 0.F) << "trial " << k;
    ASSERT_EQ(s->transmission, dot(wo, ng) * dot(s->wi, ng) < 0.F) << "trial " << k;
  }
  EXPECT_GT(scattered, kTrials / 4);
}

}  // namespace
}  // namespace ajar
