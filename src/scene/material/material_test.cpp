#include "scene/material/material.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "scene/bsdf/bsdf_catalogue.h"
#include "scene/material/bump.h"

namespace ajar {
namespace {
using testing::direction;

class Constant final : public Texture {
 public:
  explicit Constant(const Spectrum& value) : value_(value) {}
  Spectrum eval(const SurfacePoint&) const override { return value_; }
  const Spectrum* constant() const override { return &value_; }

 private:
  Spectrum value_;
};

/// slope · u, everywhere.
class Ramp final : public Texture {
 public:
  explicit Ramp(float slope) : slope_(slope) {}
  Spectrum eval(const SurfacePoint& at) const override { return Spectrum(slope_ * at.uv.x); }

 private:
  float slope_;
};

SurfacePoint flat_point() {
  SurfacePoint at;
  at.p = {0.F, 0.F, 0.F};
  at.ng = {0.F, 0.F, 1.F};
  at.ns = at.ng;
  at.uv = {0.5F, 0.5F};
  at.dpdu = {1.F, 0.F, 0.F};
  at.dpdv = {0.F, 1.F, 0.F};
  at.dndu = {0.F, 0.F, 0.F};
  at.dndv = {0.F, 0.F, 0.F};
  return at;
}

/// A scene description of materials alone, and what is built of it.
struct Fixture {
  desc::SceneDesc scene;
  TextureList textures;
  Warnings warnings;
  MaterialList materials;

  desc::TextureId constant(const Spectrum& value) {
    textures.push_back(std::make_unique<Constant>(value));
    return static_cast<int>(textures.size()) - 1;
  }
  desc::TextureId constant(float value) { return constant(Spectrum(value)); }
  template <typename Node>
  desc::MaterialId add(const Node& node) {
    desc::Material material;
    material.name = "m";
    material.name += std::to_string(scene.materials.size());
    material.node = node;
    scene.materials.push_back(material);
    return static_cast<int>(scene.materials.size()) - 1;
  }
  Bsdf bsdf(desc::MaterialId id) {
    materials = build_materials(scene, textures, warnings);
    return materials[id]->bsdf(flat_point());
  }
};

const Vec3 kWo = direction(50.F, 200.F);
const Vec3 kWi = direction(35.F, 20.F);
constexpr TransportMode kRadiance = TransportMode::Radiance;

TEST(Materials, DefaultsAreThoseOfPbrt) {
  Fixture f;
  const auto matte = f.add(desc::MatteMaterial{});
  const auto mirror = f.add(desc::MirrorMaterial{});
  const auto glass = f.add(desc::GlassMaterial{});
  const auto metal = f.add(desc::MetalMaterial{});
  EXPECT_NEAR(f.bsdf(matte).eval(kWo, kWi, kRadiance)[0], 0.5F * kInvPi * kWi.z, 1e-6F);
  EXPECT_NEAR(f.bsdf(mirror).sample(kWo, {0.5F, {0.5F, 0.5F}}, kRadiance)->weight[1], 0.9F, 1e-6F);
  EXPECT_FALSE(f.bsdf(mirror).connectible());
  const auto refracted = f.bsdf(glass).sample(kWo, {0.999F, {0.5F, 0.5F}}, kRadiance);
  ASSERT_TRUE(refracted);
  EXPECT_FLOAT_EQ(refracted->eta, 1.5F);
  const Spectrum copper = f.bsdf(metal).albedo(Vec3(0.F, 0.F, 1.F));
  EXPECT_NEAR(copper[0], 0.953F, 0.01F);
  EXPECT_NEAR(copper[2], 0.51F, 0.02F);
  EXPECT_EQ(f.materials[matte]->name, "m0");
  EXPECT_EQ(f.warnings.count(), 0U);
}

TEST(Matte, TurnsIntoOrenNayarWithSigmaInDegrees) {
  Fixture f;
  const auto rough = f.add(desc::MatteMaterial{f.constant(0.8F), f.constant(30.F)});
  const Spectrum expected = OrenNayar(kPi / 6.F).evaluate(kWo, kWi, false, kRadiance).value * 0.8F;
  // Oren–Nayar depends on the difference of azimuths only, so the frame's tangent does not matter.
  EXPECT_NEAR(f.bsdf(rough).eval(kWo, kWi, kRadiance)[0], expected[0], 1e-6F);
}

TEST(Plastic, IsLambertPlusTheHighlightOfPbrt) {
  Fixture f;
  const auto plastic =
      f.add(desc::PlasticMaterial{f.constant(0.3F), f.constant(0.6F), f.constant(0.2F), false});
  const Vec3 h = normalize(kWo + kWi);
  const double alpha = 0.2;
  const auto lambda = [&](const Vec3& w) {
    const double t = alpha * std::sqrt(1.0 / (w.z * w.z) - 1.0);
    return (std::sqrt(1.0 + t * t) - 1.0) / 2.0;
  };
  const double tan2 = 1.0 / (h.z * h.z) - 1.0;
  const double e = 1.0 + tan2 / (alpha * alpha);
  const double d = 1.0 / (kPi * alpha * alpha * std::pow(h.z, 4) * e * e);
  const double g = 1.0 / (1.0 + lambda(kWo) + lambda(kWi));
  // Indices in the order (1.5, 1): seen as if from within.
  const double fresnel = fresnel_dielectric(dot(kWo, h), 1.F / 1.5F).reflectance;
  const double value = 0.3 * kInvPi * kWi.z + 0.6 * d * g * fresnel / (4.0 * kWo.z);
  EXPECT_NEAR(f.bsdf(plastic).eval(kWo, kWi, kRadiance)[0], value, 1e-4 * value);
}

TEST(Uber, LetsLightThroughWhereItIsNotOpaque) {
  Fixture f;
  desc::UberMaterial d;
  d.kd = f.constant(0.8F);
  d.ks = f.constant(0.F);
  d.opacity = f.constant(0.25F);
  const Bsdf bsdf = f.bsdf(f.add(d));
  EXPECT_NEAR(bsdf.eval(kWo, kWi, kRadiance)[0], 0.25F * 0.8F * kInvPi * kWi.z, 1e-6F);
  // Pass-through is the first lobe and has 0.75 of 0.75 + 0.2 of the probability.
  const auto s = bsdf.sample(kWo, {0.1F, {0.5F, 0.5F}}, kRadiance);
  ASSERT_TRUE(s && s->pdf.discrete());
  EXPECT_LT(length(s->wi + kWo), 1e-6F);
  EXPECT_NEAR(s->pdf.value(), 0.75F / 0.95F, 1e-5F);
  EXPECT_NEAR(s->weight[0] * s->pdf.value(), 0.75F, 1e-5F);
}

TEST(Glass, IsRoughThinOrTintedAsAsked) {
  Fixture f;
  desc::GlassMaterial rough;
  rough.u_roughness = f.constant(0.3F);
  const auto rough_id = f.add(rough);
  desc::GlassMaterial thin;
  thin.thin = true;
  thin.kt = f.constant(Spectrum(1.F, 0.5F, 0.25F));
  const auto thin_id = f.add(thin);
  desc::GlassMaterial both = rough;
  both.thin = true;
  f.add(both);
  EXPECT_TRUE(f.bsdf(rough_id).connectible());
  EXPECT_EQ(f.warnings.count(), 1U);
  const Bsdf pane = f.bsdf(thin_id);
  EXPECT_FALSE(pane.connectible());
  const auto s = pane.sample(kWo, {0.999F, {0.5F, 0.5F}}, kRadiance);
  ASSERT_TRUE(s && s->transmission);
  EXPECT_LT(length(s->wi + kWo), 1e-6F);
  EXPECT_NEAR(s->weight[2] / s->weight[0], 0.25F, 1e-5F);
}

TEST(Glass, WithoutContrastIsSmooth) {
  Fixture f;
  desc::GlassMaterial d;
  d.u_roughness = f.constant(0.3F);
  d.eta = f.constant(1.F);
  const auto s = f.bsdf(f.add(d)).sample(kWo, {0.5F, {0.5F, 0.5F}}, kRadiance);
  ASSERT_TRUE(s);
  EXPECT_LT(length(s->wi + kWo), 1e-6F);
  EXPECT_NEAR(s->weight[0], 1.F, 1e-6F);
}

TEST(Mix, ScalesBothMaterials) {
  Fixture f;
  const auto a = f.add(desc::MatteMaterial{f.constant(0.8F)});
  const auto b = f.add(desc::MatteMaterial{f.constant(0.4F)});
  const auto mix = f.add(desc::MixMaterial{f.constant(Spectrum(0.25F, 1.F, 0.F)), a, b});
  const Spectrum value = f.bsdf(mix).eval(kWo, kWi, kRadiance) * (kPi / kWi.z);
  EXPECT_NEAR(value[0], 0.25F * 0.8F + 0.75F * 0.4F, 1e-5F);
  EXPECT_NEAR(value[1], 0.8F, 1e-5F);
  EXPECT_NEAR(value[2], 0.4F, 1e-5F);
}

TEST(Mix, OfTooManyLobesOrWrongIdsIsReported) {
  Fixture f;
  auto last = f.add(desc::MatteMaterial{});
  for (int k = 0; k < 5; ++k) last = f.add(desc::MixMaterial{desc::kNone, last, last});
  const auto wrong = f.add(desc::MixMaterial{desc::kNone, 99, last + 50});
  const Spectrum value = f.bsdf(last).eval(kWo, kWi, kRadiance);
  EXPECT_NEAR(value[0], 0.5F * kInvPi * kWi.z, 1e-5F);
  EXPECT_NEAR(f.bsdf(wrong).eval(kWo, kWi, kRadiance)[0], 0.5F * kInvPi * kWi.z, 1e-5F);
  EXPECT_GT(f.warnings.count(), 2U);
}

TEST(Mix, OfMixesDoesNotDoubleItsWorkWithEveryLevel) {
  Fixture f;
  auto last = f.add(desc::MatteMaterial{});
  // 2^40 leaves, and a chain deeper than the stack if every level were a call.
  for (int k = 0; k < 40; ++k) last = f.add(desc::MixMaterial{desc::kNone, last, last});
  for (int k = 0; k < 200000; ++k) last = f.add(desc::MixMaterial{desc::kNone, last, 0});
  const Spectrum value = f.bsdf(last).eval(kWo, kWi, kRadiance);
  EXPECT_NEAR(value[0], 0.5F * kInvPi * kWi.z, 1e-5F);
  EXPECT_NE(f.warnings.messages().front().find("at most 8 are possible"), std::string::npos);
}

TEST(Interface, HasNoLobes) {
  Fixture f;
  const auto id = f.add(desc::InterfaceMaterial{});
  EXPECT_TRUE(f.bsdf(id).empty());
  EXPECT_TRUE(f.materials[id]->is_interface());
}

TEST(Disney, ThinSheetsTransmitDiffusely) {
  Fixture f;
  desc::DisneyMaterial d;
  d.thin = true;
  d.diff_trans = f.constant(1.2F);
  d.color = f.constant(0.7F);
  const Vec3 below(kWi.x, kWi.y, -kWi.z);
  EXPECT_NEAR(f.bsdf(f.add(d)).eval(kWo, below, kRadiance)[0], 0.6F * 0.7F * kInvPi * kWi.z, 1e-5F);
}

TEST(Disney, MetalHasTheColourOfTheBaseAtNormalIncidence) {
  Fixture f;
  desc::DisneyMaterial d;
  d.metallic = f.constant(1.F);
  d.color = f.constant(Spectrum(0.9F, 0.6F, 0.1F));
  d.roughness = f.constant(0.3F);
  const Vec3 up(0.F, 0.F, 1.F);
  const Spectrum value = f.bsdf(f.add(d)).eval(up, up, kRadiance);
  EXPECT_NEAR(value[1] / value[0], 0.6F / 0.9F, 1e-4F);
  EXPECT_NEAR(value[2] / value[0], 0.1F / 0.9F, 1e-4F);
}

TEST(Materials, AllSurviveNonsenseTextures) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  Rng rng(31);
  for (const float nonsense : {nan, inf, -inf, -3.F, 1e30F, 0.F}) {
    Fixture f;
    const auto t = f.constant(nonsense);
    f.add(desc::MatteMaterial{t, t});
    f.add(desc::MirrorMaterial{t});
    f.add(desc::GlassMaterial{t, t, t, t, t});
    f.add(desc::GlassMaterial{desc::kNone, desc::kNone, t, t, t});
    f.add(desc::MetalMaterial{t, t, t, t});
    f.add(desc::PlasticMaterial{t, t, t});
    f.add(desc::SubstrateMaterial{t, t, t, t});
    f.add(desc::UberMaterial{t, t, t, t, t, t, t, t});
    f.add(desc::TranslucentMaterial{t, t, t, t, t});
    f.add(desc::DisneyMaterial{t, t, t, t, t, t, t, t, t, t, t, t, t, true});
    f.add(desc::DisneyMaterial{t, t, t, t, t, t, t, t, t, t, t, t, t, false});
    f.add(desc::MixMaterial{t, 0, 4});
    f.materials = build_materials(f.scene, f.textures, f.warnings);
    for (const auto& material : f.materials) {
      const Bsdf bsdf = material->bsdf(flat_point());
      for (int k = 0; k < 500; ++k) {
        const Vec3 wo = testing::random_direction(rng);
        const auto s = bsdf.sample(wo, testing::random_uniforms(rng), kRadiance);
        const Vec3 wi = s ? s->wi : testing::random_direction(rng);
        EXPECT_TRUE(bsdf.eval(wo, wi, kRadiance).is_finite()) << material->name << nonsense;
        if (s) {
          EXPECT_TRUE(s->weight.is_finite()) << material->name << nonsense;
        }
      }
    }
  }
}

TEST(Materials, AnisotropyFollowsTheTangent) {
  Fixture f;
  const auto id = f.add(
      desc::MetalMaterial{desc::kNone, desc::kNone, f.constant(0.5F), f.constant(0.05F), false});
  f.materials = build_materials(f.scene, f.textures, f.warnings);
  SurfacePoint at = flat_point();
  at.dpdu = {0.F, 3.F, 1.F};
  const Bsdf bsdf = f.materials[id]->bsdf(at);
  const Vec3 up(0.F, 0.F, 1.F);
  // Rough along u, which is the world's y here: that way the highlight is wide.
  EXPECT_GT(bsdf.eval(up, direction(30.F, 90.F), kRadiance)[0],
            10.F * bsdf.eval(up, direction(30.F, 0.F), kRadiance)[0]);
}

TEST(Bump, TiltsTheNormalAgainstTheSlope) {
  const Ramp ramp(0.5F);
  const BumpedFrame bumped = bump_frame(TextureSlot(&ramp), flat_point());
  const Vec3 expected = normalize(Vec3(-0.5F, 0.F, 1.F));
  EXPECT_LT(length(bumped.ns - expected), 1e-3F);
  EXPECT_NEAR(dot(bumped.ns, normalize(bumped.dpdu)), 0.F, 1e-3F);
  Fixture f;
  f.textures.push_back(std::make_unique<Ramp>(0.5F));
  f.scene.materials.resize(2);
  f.scene.materials[0].bump = 0;
  f.scene.materials[0].node = desc::MatteMaterial{};
  f.scene.materials[1].node = desc::MixMaterial{desc::kNone, 0, 0};
  EXPECT_LT(length(f.bsdf(0).ns() - expected), 1e-3F);
  EXPECT_LT(length(f.bsdf(1).ns() - expected), 1e-3F);
  EXPECT_EQ(f.bsdf(0).ng(), Vec3(0.F, 0.F, 1.F));
}

TEST(Bump, KeepsTheNormalOnItsSideAndWhereItIsDegenerate) {
  const Ramp ramp(0.5F);
  SurfacePoint flipped = flat_point();
  flipped.ng = flipped.ns = Vec3(0.F, 0.F, -1.F);
  EXPECT_GT(dot(bump_frame(TextureSlot(&ramp), flipped).ns, flipped.ng), 0.F);
  for (const float slope : {std::numeric_limits<float>::quiet_NaN(), 1e38F}) {
    const Ramp broken(slope);
    EXPECT_EQ(bump_frame(TextureSlot(&broken), flat_point()).ns, Vec3(0.F, 0.F, 1.F));
  }
  SurfacePoint pinched = flat_point();
  pinched.dpdv = pinched.dpdu;
  EXPECT_EQ(bump_frame(TextureSlot(&ramp), pinched).ns, Vec3(0.F, 0.F, 1.F));
}

}  // namespace
}  // namespace ajar
