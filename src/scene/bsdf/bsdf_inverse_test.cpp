#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "scene/bsdf/bsdf_catalogue.h"

namespace ajar {
namespace {

using testing::catalogue;
using testing::NamedBsdf;
using testing::random_direction;
using testing::random_uniforms;

/// |∂ω/∂u| at `u`, by central differences of that step: one over the density of the direction.
/// Empty across the line from where on directions are mirrored, and where the map from the square
/// has a kink.
std::optional<double> stretch(const Bsdf& bsdf, const Vec3& wo, const BsdfUniforms& u,
                              float width) {
  const Vec2 centred = u.direction * 2.F - Vec2(1.F);
  if (std::abs(std::abs(centred.x) - std::abs(centred.y)) < 0.02F) return std::nullopt;
  // Near the horizon the densities at both ends differ.
  if (std::max(std::abs(centred.x), std::abs(centred.y)) > 0.9F) return std::nullopt;
  bool torn = false;
  const auto difference = [&](const Vec2& step) {
    const auto toward = [&](const Vec2& direction) {
      const auto sample = bsdf.sample(wo, {u.lobe, direction}, TransportMode::Radiance);
      return sample ? sample->wi : Vec3(0.F);
    };
    const Vec3 shift = toward(u.direction + step) - toward(u.direction - step);
    torn = torn || length(shift) > 0.1F;
    return shift / (2.F * width);
  };
  const Vec3 normal = cross(difference({width, 0.F}), difference({0.F, width}));
  if (torn) return std::nullopt;
  return double{length(normal)};
}

/// Derivative of the inverse; empty, too, where half the step has another answer, by curvature or
/// by roundings.
std::optional<double> stretch(const Bsdf& bsdf, const Vec3& wo, const BsdfUniforms& u) {
  const std::optional<double> wide = stretch(bsdf, wo, u, 1e-3F);
  const std::optional<double> narrow = stretch(bsdf, wo, u, 5e-4F);
  if (!wide || !narrow || std::abs(*wide / *narrow - 1.0) > 0.01) return std::nullopt;
  return wide;
}

TEST(BsdfInverse, FindsTheNumbersOfADirectionAndTheirDensity) {
  std::set<std::string> inverted;
  int densities = 0;
  for (const float tilt : {0.F, 35.F}) {
    for (const NamedBsdf& named : catalogue(tilt)) {
      SCOPED_TRACE(named.name);
      const Bsdf& bsdf = named.bsdf;
      Rng rng(1);
      for (int i = 0; i < 400; ++i) {
        const Vec3 wo = random_direction(rng);
        const BsdfUniforms u = random_uniforms(rng);
        const auto sample = bsdf.sample(wo, u, TransportMode::Radiance);
        if (!sample) continue;
        const auto inverse = bsdf.inverse(wo, sample->wi, u.lobe, Inverted::Rough);
        if (!inverse) continue;
        inverted.insert(named.name);
        ASSERT_FALSE(sample->pdf.discrete()) << "a specular lobe has no inverse";
        const auto again = bsdf.sample(wo, {u.lobe, inverse->direction}, TransportMode::Radiance);
        ASSERT_TRUE(again);
        EXPECT_LT(length(again->wi - sample->wi), 1e-3F);
        if (const auto area = stretch(bsdf, wo, u)) {
          EXPECT_NEAR(*area * double{inverse->pdf}, 1.0, 0.02);
          ++densities;
        }
      }
    }
  }
  EXPECT_GT(densities, 1000);
  for (const char* name :
       {"lambert", "lambert transmission", "oren-nayar", "disney diffuse", "substrate 0.1",
        "ggx 0.1", "beckmann 0.15", "rough glass 0.15", "rough bubble 0.3", "disney clearcoat",
        "echo under a coat", "plastic", "uber", "translucent", "disney"}) {
    EXPECT_TRUE(inverted.count(name)) << name;
  }
}

TEST(BsdfInverse, OfDiffuseLobesAloneLeavesOutHighlights) {
  const Vec3 up(0.F, 0.F, 1.F);
  const Vec3 sideways(0.6F, 0.F, 0.8F);
  std::set<std::string> diffuse;
  std::set<std::string> others;
  for (const NamedBsdf& named : catalogue(0.F)) {
    for (const float u : {0.01F, 0.99F}) {
      const bool found = named.bsdf.inverse(up, sideways, u, Inverted::Diffuse).has_value();
      (found ? diffuse : others).insert(named.name);
    }
  }
  for (const char* name :
       {"lambert", "lambert transmission", "oren-nayar", "disney diffuse", "echo under a coat"}) {
    EXPECT_TRUE(diffuse.count(name) && !others.count(name)) << name;
  }
  for (const char* name : {"substrate 0.1", "plastic"}) {
    EXPECT_TRUE(diffuse.count(name) && others.count(name)) << name;
  }
  for (const char* name : {"ggx 0.1", "rough glass 0.5", "disney clearcoat", "mirror"}) {
    EXPECT_TRUE(!diffuse.count(name) && others.count(name)) << name;
  }
}

TEST(BsdfInverse, ASpecularEventIsRepeated) {
  Rng rng(6);
  int events = 0;
  for (const float tilt : {0.F, 25.F}) {
    for (const NamedBsdf& named : catalogue(tilt)) {
      for (int i = 0; i < 300; ++i) {
        const Vec3 wo = random_direction(rng);
        const auto s = named.bsdf.sample(wo, random_uniforms(rng), TransportMode::Importance);
        if (!s) continue;
        ASSERT_EQ(s->event().specular(), s->pdf.discrete()) << named.name;
        if (!s->event().specular()) continue;
        const auto again = named.bsdf.specular(wo, s->event(), TransportMode::Importance);
        ASSERT_TRUE(again) << named.name;
        ++events;
        EXPECT_EQ(again->wi, s->wi) << named.name;
        EXPECT_EQ(again->weight, s->weight) << named.name;
        EXPECT_EQ(again->pdf.value(), s->pdf.value()) << named.name;
        EXPECT_EQ(again->reverse_pdf.value(), s->reverse_pdf.value()) << named.name;
      }
    }
  }
  EXPECT_GT(events, 3000);
}

TEST(BsdfInverse, IsEmptyOutsideOfALobesSupport) {
  const Vec3 up(0.F, 0.F, 1.F);
  const Vec3 sideways(0.6F, 0.F, 0.8F);
  Bsdf matt(Frame(), up);
  matt.add(Lambert{});
  EXPECT_GT(matt.inverse(up, sideways, 0.5F, Inverted::Rough)->pdf, 0.F);
  EXPECT_GT(matt.inverse(-up, -sideways, 0.5F, Inverted::Rough)->pdf, 0.F);
  EXPECT_EQ(matt.inverse(up, -sideways, 0.5F, Inverted::Rough)->pdf, 0.F);
  Bsdf paper(Frame(), up);
  paper.add(Lambert{}, Spectrum(0.25F));
  paper.add(LambertTransmission{}, Spectrum(0.75F));
  EXPECT_GT(paper.inverse(up, sideways, 0.2F, Inverted::Rough)->pdf, 0.F);
  EXPECT_EQ(paper.inverse(up, -sideways, 0.2F, Inverted::Rough)->pdf, 0.F);
  EXPECT_EQ(paper.inverse(up, sideways, 0.3F, Inverted::Rough)->pdf, 0.F);
  EXPECT_GT(paper.inverse(up, -sideways, 0.3F, Inverted::Rough)->pdf, 0.F);
  Bsdf mirror(Frame(), up);
  mirror.add(Mirror{});
  EXPECT_FALSE(mirror.inverse(up, up, 0.5F, Inverted::Rough));
  const Vec3 grazing(1.F, 0.F, 1e-7F);
  ASSERT_FALSE(matt.sample(grazing, {0.5F, {0.5F, 0.5F}}, TransportMode::Radiance));
  EXPECT_FALSE(matt.inverse(grazing, sideways, 0.5F, Inverted::Rough));
}

}  // namespace
}  // namespace ajar
