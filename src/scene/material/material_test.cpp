#include "scene/material/material.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "scene/bsdf/bsdf_catalogue.h"
#include "scene/desc/models.h"
#include "scene/material/relief.h"

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

  desc::Value constant(const Spectrum& value) {
    textures.push_back(std::make_unique<Constant>(value));
    return desc::TextureRef{static_cast<int>(textures.size()) - 1};
  }
  desc::Value constant(float value) { return constant(Spectrum(value)); }
  /// slope · u.
  desc::Value ramp(float slope) {
    textures.push_back(std::make_unique<Ramp>(slope));
    return desc::TextureRef{static_cast<int>(textures.size()) - 1};
  }
  desc::MaterialId add(std::string_view model, desc::Node::Given given = {}) {
    return add(desc::material_node(model, given));
  }
  desc::MaterialId add(const desc::Node& node) {
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

desc::Node mix_of(desc::MaterialId first, desc::MaterialId second,
                  const Vec3& amount = Vec3(0.5F)) {
  return desc::material_node("mix", {{"amount", amount},
                                     {"first", desc::MaterialRef{first}},
                                     {"second", desc::MaterialRef{second}}});
}

const Vec3 kWo = direction(50.F, 200.F);
const Vec3 kWi = direction(35.F, 20.F);
constexpr TransportMode kRadiance = TransportMode::Radiance;

TEST(Diffuse, MayCountTheLightBetweenFacets) {
  const auto albedo = [](bool between) {
    Fixture f;
    const desc::MaterialId id = f.add("diffuse", {{"reflectance", Vec3(0.5F)},
                                                  {"sigma", 40.5142342F},  // variance ½
                                                  {"between_facets", between}});
    const Vec3 up(0.F, 0.F, 1.F);
    return f.bsdf(id).eval(up, kWi, kRadiance)[0] / (kInvPi * kWi.z);
  };
  const float c1 = 1.F - 0.5F * 0.5F / 0.83F;
  EXPECT_NEAR(albedo(false), 0.5F * c1, 1e-5F);
  EXPECT_NEAR(albedo(true), 0.5F * c1 + 0.25F * 0.17F * 0.5F / 0.63F, 1e-5F);
}

TEST(CoatedDiffuseMaterial, ReflectsBelowTheCoatAsItSays) {
  const Spectrum color(0.2F, 0.5F, 0.9F);
  const float eta = 1.5F;
  const auto value = [&](desc::Node::Given given) {
    Fixture f;
    desc::Node node = desc::material_node("coated_diffuse", given);
    node.set("coat", "dielectric");
    node.set("eta", eta);
    node.set("roughness", 0.F);
    node.set("diffuse_reflectance", Vec3(color[0], color[1], color[2]));
    const desc::MaterialId id = f.add(node);
    return f.bsdf(id).eval(kWo, kWi, kRadiance) / (kInvPi * kWi.z);
  };
  const float through = (1.F - fresnel_dielectric(kWo.z, eta).reflectance) *
                        (1.F - fresnel_dielectric(kWi.z, eta).reflectance) / (eta * eta);
  const float back = 1.F - Coat{eta, 0.F}.mean_transmittance() / (eta * eta);
  const Spectrum base = value({});
  const Spectrum white = value({{"inner_reflections", "white"}});
  const Spectrum once = value({{"bounces", 1}, {"coat_reflectance", Vec3(0.F)}});
  const Spectrum dark = value({{"bounces", 1}, {"coat_depth", Vec3(0.F, 0.F, 0.7F)}});
  const auto inner = [&](const Vec3& w) {
    return std::sqrt(1.F - (1.F - w.z * w.z) / (eta * eta));
  };
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(base[i], through * color[i] / (1.F - color[i] * back), 1e-5F);
    EXPECT_NEAR(white[i], through * color[i] / (1.F - back), 1e-5F);
    EXPECT_NEAR(once[i], through * color[i], 1e-5F);
  }
  EXPECT_NEAR(dark[1], once[1], 1e-6F);
  EXPECT_NEAR(dark[2] / once[2], std::exp(-0.7F / inner(kWo) - 0.7F / inner(kWi)), 1e-5F);
}

TEST(CoatedDiffuseMaterial, TintsOnlyWhatTheCoatReflects) {
  const auto mirror_of = [](const Vec3& tint) {
    Fixture f;
    const desc::MaterialId id = f.add("coated_diffuse", {{"coat", "dielectric"},
                                                         {"roughness", 0.F},
                                                         {"diffuse_reflectance", Vec3(0.F)},
                                                         {"coat_reflectance", tint}});
    return f.bsdf(id).sample(kWo, {0.5F, {0.5F, 0.5F}}, kRadiance)->weight;
  };
  const float f = fresnel_dielectric(kWo.z, 1.5F).reflectance;
  EXPECT_NEAR(mirror_of(Vec3(1.F))[0], f, 1e-5F);
  EXPECT_NEAR(mirror_of(Vec3(0.25F, 1.F, 1.F))[0], 0.25F * f, 1e-5F);
}

TEST(CoatedConductorMaterial, IsDarkerBelowACoatThatAbsorbs) {
  const auto albedo = [](float depth, float roughness) {
    Fixture f;
    const desc::MaterialId id = f.add("coated_conductor", {{"coat_depth", Vec3(depth, 0.F, 0.F)},
                                                           {"roughness", roughness},
                                                           {"reflectance", Vec3(0.9F)}});
    return f.bsdf(id).albedo(Vec3(0.F, 0.F, 1.F))[0];
  };
  const float f = fresnel_dielectric(1.F, 1.5F).reflectance;
  for (const float roughness : {0.F, 0.3F}) {
    const float clear = albedo(0.F, roughness) - f;
    const float dark = albedo(0.5F, roughness) - f;
    // Along the normal, or on average 1.146 times as long a way.
    const float least = std::exp(-1.F * 1.15F);
    EXPECT_GT(dark / clear, 0.95F * least) << roughness;
    EXPECT_LT(dark / clear, 1.05F * std::exp(-1.F)) << roughness;
  }
}

TEST(Principled, BlendsMetalAndDielectricOnceUnlessTwice) {
  const Vec3 color(1.F, 0.5F, 0.1F);
  const auto gloss = [&](float metallic, float tint, const char* blend) {
    Fixture f;
    const desc::MaterialId id = f.add("principled", {{"base_color", color},
                                                     {"metallic", metallic},
                                                     {"specular_tint", tint},
                                                     {"roughness", 0.5F},
                                                     {"blend", blend}});
    const desc::MaterialId black =
        f.add("principled", {{"base_color", Vec3(0.F)}, {"metallic", 0.F}, {"roughness", 0.5F}});
    const desc::MaterialId white =
        f.add("principled", {{"base_color", Vec3(1.F)}, {"metallic", 1.F}, {"roughness", 0.5F}});
    const Vec3 up(0.F, 0.F, 1.F);
    const float none = f.bsdf(black).eval(up, up, kRadiance)[0];  // 0.04 D G
    const float all = f.bsdf(white).eval(up, up, kRadiance)[0];   // D G
    const Spectrum diffuse = rgb_spectrum(color) * ((1.F - metallic) * kInvPi);
    EXPECT_NEAR(none / all, 0.04F, 1e-4F);
    return (f.bsdf(id).eval(up, up, kRadiance) - diffuse) / all;
  };
  const Spectrum once = gloss(0.5F, 0.F, "once");
  const Spectrum twice = gloss(0.5F, 0.F, "twice");
  const Spectrum tinted = gloss(0.F, 1.F, "once");
  const float brightness = luminance(rgb_spectrum(color));
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(once[i], 0.5F * 0.04F + 0.5F * color[i], 2e-3F);
    EXPECT_NEAR(twice[i], 0.5F * 0.04F + 0.5F * (0.5F * 0.04F + 0.5F * color[i]), 2e-3F);
    EXPECT_NEAR(tinted[i], 0.04F * color[i] / brightness, 2e-3F);
  }
}

TEST(Principled, SpecularStrengthIsAFactorOfTheDielectricAtAllAngles) {
  const auto gloss = [](float metallic, float tint, float strength, const Vec3& wo,
                        const Vec3& wi) {
    Fixture f;
    const auto with = [&](float factor) {
      return f
          .bsdf(f.add("principled", {{"base_color", Vec3(0.5F)},
                                     {"metallic", metallic},
                                     {"specular_tint", tint},
                                     {"specular_strength", factor}}))
          .eval(wo, wi, kRadiance)[0];
    };
    const float none = with(0.F);
    return std::pair((with(strength) - none) / (with(1.F) - none), none);
  };
  const Vec3 grazing = direction(85.F, 0.F);
  for (const float tint : {0.F, 0.5F}) {
    EXPECT_NEAR(gloss(0.F, tint, 0.25F, kWo, kWi).first, 0.25F, 1e-4F);
    EXPECT_NEAR(gloss(0.F, tint, 0.25F, grazing, direction(85.F, 180.F)).first, 0.25F, 1e-4F);
    EXPECT_NEAR(gloss(0.5F, tint, 0.25F, grazing, direction(85.F, 180.F)).first, 0.25F, 1e-4F);
  }
  EXPECT_GT(gloss(0.5F, 0.F, 0.25F, grazing, direction(85.F, 180.F)).second, 0.1F)
      << "the metal keeps its own";
}

TEST(Principled, VarnishIsNotOnGlass) {
  const auto mirror_of = [](float transmission) {
    Fixture f;
    const desc::MaterialId id =
        f.add("principled",
              {{"base_color", Vec3(0.F)}, {"coat", 1.F}, {"specular_transmission", transmission}});
    float sum = 0.F;
    for (int i = 0; i < 1000; ++i) {
      const auto s = f.bsdf(id).sample(kWo, {(static_cast<float>(i) + 0.5F) / 1000.F, {0.3F, 0.3F}},
                                       kRadiance);
      if (s && s->event().specular() && !s->transmission) sum += s->weight[0] / 1000.F;
    }
    return sum;
  };
  EXPECT_NEAR(mirror_of(0.F), fresnel_dielectric(kWo.z, 1.5F).reflectance, 5e-3F);
  EXPECT_EQ(mirror_of(1.F), 0.F);
}

TEST(Materials, HaveDefaults) {
  Fixture f;
  const auto matte = f.add("diffuse");
  const auto mirror = f.add("mirror");
  const auto glass = f.add("dielectric");
  const auto metal = f.add("conductor");
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

/// What may stay without chains: of a mixture of diffuse materials nobody has asked it.
TEST(Materials, SayWhetherTheyAreDiffuse) {
  Fixture f;
  const auto smooth = f.add("diffuse");
  const auto rough = f.add("diffuse", {{"sigma", 20.F}});
  for (const char* model : {"mirror", "dielectric", "conductor", "plastic", "coated_diffuse",
                            "translucent", "principled"}) {
    const auto other = f.add(model);
    f.bsdf(other);
    EXPECT_FALSE(f.materials[static_cast<std::size_t>(other)]->is_diffuse()) << model;
  }
  EXPECT_TRUE(f.materials[static_cast<std::size_t>(smooth)]->is_diffuse());
  EXPECT_TRUE(f.materials[static_cast<std::size_t>(rough)]->is_diffuse());
}

TEST(Materials, NodesOfNoModelAreLocatedErrors) {
  Fixture f;
  f.add(desc::Node());
  f.scene.materials[0].where = {std::make_shared<const std::string>("a.pbrt"), 3, 1};
  try {
    f.bsdf(0);
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(), "a.pbrt:3:1: this material has no model");
  }
}

TEST(Materials, WarnOfColorsThatAreClamped) {
  const auto warnings_of = [](const Vec3& reflectance) {
    Fixture f;
    f.bsdf(f.add("diffuse", {{"reflectance", reflectance}}));
    return f.warnings.messages().empty() ? std::string() : f.warnings.messages().front();
  };
  EXPECT_EQ(warnings_of({0.F, 0.5F, 1.F}), "");
  EXPECT_EQ(warnings_of({0.F, 0.5F, std::nextafter(1.F, 2.F)}), "");
  for (const Vec3& color : {Vec3(2.F, 0.5F, 0.5F), Vec3(0.5F, 0.5F, -0.3F)}) {
    EXPECT_NE(warnings_of(color).find("\"reflectance\" of a diffuse material"), std::string::npos)
        << warnings_of(color);
  }
}

TEST(Materials, RoughnessOnTheLogScaleIsRemapped) {
  Fixture f;
  const auto remapped = f.add("plastic", {{"roughness", 0.3F}, {"roughness_scale", "log"}});
  const auto alpha = f.add("plastic", {{"roughness", roughness_to_alpha(0.3F)}});
  const auto textured = f.add("plastic", {{"roughness", f.ramp(0.6F)}, {"roughness_scale", "log"}});
  EXPECT_EQ(f.bsdf(remapped).eval(kWo, kWi, kRadiance), f.bsdf(alpha).eval(kWo, kWi, kRadiance));
  EXPECT_EQ(f.bsdf(textured).eval(kWo, kWi, kRadiance), f.bsdf(alpha).eval(kWo, kWi, kRadiance));
}

TEST(Diffuse, TurnsIntoOrenNayarWithSigmaInDegrees) {
  Fixture f;
  const auto rough = f.add("diffuse", {{"reflectance", f.constant(0.8F)}, {"sigma", 30.F}});
  const Spectrum expected = OrenNayar(kPi / 6.F).evaluate(kWo, kWi, false, kRadiance).value * 0.8F;
  // Oren–Nayar depends on the difference of azimuths only, so the frame's tangent does not matter.
  EXPECT_NEAR(f.bsdf(rough).eval(kWo, kWi, kRadiance)[0], expected[0], 1e-6F);
}

TEST(Plastic, IsLambertPlusTheHighlightOfPbrt) {
  Fixture f;
  const auto plastic = f.add("plastic", {{"diffuse_reflectance", Vec3(0.3F)},
                                         {"glossy_reflectance", Vec3(0.6F)},
                                         {"roughness", f.constant(0.2F)}});
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

TEST(Composite, LetsLightThroughWhereItIsNotOpaque) {
  Fixture f;
  const Bsdf bsdf = f.bsdf(f.add("composite", {{"diffuse_reflectance", f.constant(0.8F)},
                                               {"glossy_reflectance", f.constant(0.F)},
                                               {"opacity", f.constant(0.25F)}}));
  EXPECT_NEAR(bsdf.eval(kWo, kWi, kRadiance)[0], 0.25F * 0.8F * kInvPi * kWi.z, 1e-6F);
  // Pass-through is the first lobe and has 0.75 of 0.75 + 0.2 of the probability.
  const auto s = bsdf.sample(kWo, {0.1F, {0.5F, 0.5F}}, kRadiance);
  ASSERT_TRUE(s && s->pdf.discrete());
  EXPECT_LT(length(s->wi + kWo), 1e-6F);
  EXPECT_NEAR(s->pdf.value(), 0.75F / 0.95F, 1e-5F);
  EXPECT_NEAR(s->weight[0] * s->pdf.value(), 0.75F, 1e-5F);
}

TEST(Dielectric, IsRoughThinOrTintedAsAsked) {
  Fixture f;
  const auto rough_id = f.add("dielectric", {{"roughness", 0.3F}});
  const auto thin_id =
      f.add("dielectric", {{"thin", true}, {"transmittance", Vec3(1.F, 0.5F, 0.25F)}});
  f.add("dielectric", {{"roughness", 0.3F}, {"thin", true}});
  EXPECT_TRUE(f.bsdf(rough_id).connectible());
  EXPECT_EQ(f.warnings.count(), 1U);
  const Bsdf pane = f.bsdf(thin_id);
  EXPECT_FALSE(pane.connectible());
  const auto s = pane.sample(kWo, {0.999F, {0.5F, 0.5F}}, kRadiance);
  ASSERT_TRUE(s && s->transmission);
  EXPECT_LT(length(s->wi + kWo), 1e-6F);
  EXPECT_NEAR(s->weight[2] / s->weight[0], 0.25F, 1e-5F);
}

TEST(Facets, HideEachOtherTogetherOrAlone) {
  Fixture f;
  const auto metal = [&](const char* distribution, const char* masking) {
    return f.add("conductor", {{"roughness", 0.5F},
                               {"distribution", std::string(distribution)},
                               {"masking", std::string(masking)}});
  };
  // Of the same directions, only the masking differs. Source: Heitz 2014, equations 23 and 99, with
  // Λ of both directions alike.
  const Vec3 wo = direction(75.F, 0.F);
  const Vec3 wi = direction(75.F, 180.F);
  const auto expect_ratio = [&](const char* distribution, double lambda) {
    const auto joint = metal(distribution, "joint");
    const auto separable = metal(distribution, "separable");
    EXPECT_NEAR(
        f.bsdf(separable).eval(wo, wi, kRadiance)[1] / f.bsdf(joint).eval(wo, wi, kRadiance)[1],
        (1.0 + 2.0 * lambda) / ((1.0 + lambda) * (1.0 + lambda)), 1e-4)
        << distribution;
  };
  const double slope = std::tan(75.0 * M_PI / 180.0) * 0.5;
  expect_ratio("ggx", 0.5 * (std::sqrt(1.0 + slope * slope) - 1.0));
  const double a = 1.0 / slope;
  expect_ratio("beckmann",
               0.5 * (std::erf(a) - 1.0) + std::exp(-a * a) / (2.0 * a * std::sqrt(M_PI)));
  // Glass has the same facets.
  const auto glass = [&](const char* masking) {
    return f.add("dielectric", {{"roughness", 0.5F}, {"masking", std::string(masking)}});
  };
  const double lambda = 0.5 * (std::sqrt(1.0 + slope * slope) - 1.0);
  const auto joint = glass("joint");
  const auto separable = glass("separable");
  EXPECT_NEAR(
      f.bsdf(separable).eval(wo, wi, kRadiance)[1] / f.bsdf(joint).eval(wo, wi, kRadiance)[1],
      (1.0 + 2.0 * lambda) / ((1.0 + lambda) * (1.0 + lambda)), 1e-4);
  const auto beckmann =
      f.add("dielectric", {{"roughness", 0.5F}, {"distribution", std::string("beckmann")}});
  EXPECT_NE(f.bsdf(beckmann).eval(wo, wi, kRadiance)[1], f.bsdf(joint).eval(wo, wi, kRadiance)[1]);
}

TEST(Dielectric, WithoutContrastIsSmooth) {
  Fixture f;
  const auto id = f.add("dielectric", {{"roughness", 0.3F}, {"eta", f.constant(1.F)}});
  const auto s = f.bsdf(id).sample(kWo, {0.5F, {0.5F, 0.5F}}, kRadiance);
  ASSERT_TRUE(s);
  EXPECT_LT(length(s->wi + kWo), 1e-6F);
  EXPECT_NEAR(s->weight[0], 1.F, 1e-6F);
}

TEST(Mix, ScalesBothMaterials) {
  Fixture f;
  const auto a = f.add("diffuse", {{"reflectance", f.constant(0.8F)}});
  const auto b = f.add("diffuse", {{"reflectance", f.constant(0.4F)}});
  const auto mix = f.add(mix_of(a, b, Vec3(0.25F, 1.F, 0.F)));
  const Spectrum value = f.bsdf(mix).eval(kWo, kWi, kRadiance) * (kPi / kWi.z);
  EXPECT_NEAR(value[0], 0.25F * 0.8F + 0.75F * 0.4F, 1e-5F);
  EXPECT_NEAR(value[1], 0.8F, 1e-5F);
  EXPECT_NEAR(value[2], 0.4F, 1e-5F);
}

TEST(Mix, OfTooManyLobesOrWrongIdsIsReported) {
  Fixture f;
  auto last = f.add("diffuse");
  for (int k = 0; k < 5; ++k) last = f.add(mix_of(last, last));
  const auto wrong = f.add(mix_of(99, last + 50));
  const Spectrum value = f.bsdf(last).eval(kWo, kWi, kRadiance);
  EXPECT_NEAR(value[0], 0.5F * kInvPi * kWi.z, 1e-5F);
  EXPECT_NEAR(f.bsdf(wrong).eval(kWo, kWi, kRadiance)[0], 0.5F * kInvPi * kWi.z, 1e-5F);
  EXPECT_GT(f.warnings.count(), 2U);
}

TEST(Mix, OfMixesDoesNotDoubleItsWorkWithEveryLevel) {
  Fixture f;
  auto last = f.add("diffuse");
  // 2^40 leaves, and a chain deeper than the stack if every level were a call.
  for (int k = 0; k < 40; ++k) last = f.add(mix_of(last, last));
  for (int k = 0; k < 200000; ++k) last = f.add(mix_of(last, 0));
  const Spectrum value = f.bsdf(last).eval(kWo, kWi, kRadiance);
  EXPECT_NEAR(value[0], 0.5F * kInvPi * kWi.z, 1e-5F);
  EXPECT_NE(f.warnings.messages().front().find("at most 8 are possible"), std::string::npos);
}

TEST(Interface, HasNoLobes) {
  Fixture f;
  const auto id = f.add("interface");
  EXPECT_TRUE(f.bsdf(id).empty());
  EXPECT_TRUE(f.materials[id]->is_interface());
}

TEST(Principled, ThinSheetsTransmitDiffusely) {
  Fixture f;
  const auto id = f.add(
      "principled",
      {{"thin", true}, {"diffuse_transmission", f.constant(1.2F)}, {"base_color", Vec3(0.7F)}});
  const Vec3 below(kWi.x, kWi.y, -kWi.z);
  EXPECT_NEAR(f.bsdf(id).eval(kWo, below, kRadiance)[0], 0.6F * 0.7F * kInvPi * kWi.z, 1e-5F);
}

/// f |cos θ_i| of a principled material.
Spectrum principled_value(desc::Node::Given given, const Vec3& wo, const Vec3& wi) {
  Fixture f;
  const desc::MaterialId id = f.add("principled", given);
  return f.bsdf(id).eval(wo, wi, kRadiance);
}
const Vec3 kBelow(kWi.x, kWi.y, -kWi.z);

TEST(Principled, MetalRefractsNothingUnlessItIsBlendedTwice) {
  const auto through = [](float metallic, const char* blend) {
    return principled_value({{"base_color", Vec3(0.25F)},
                             {"specular_transmission", 0.5F},
                             {"metallic", metallic},
                             {"blend", blend}},
                            kWo, kBelow)[0];
  };
  EXPECT_GT(through(0.F, "once"), 0.F);
  EXPECT_NEAR(through(0.75F, "once"), 0.25F * through(0.F, "once"), 1e-6F);
  EXPECT_NEAR(through(0.75F, "twice"), through(0.F, "once"), 1e-6F);
}

TEST(Principled, MetalTransmitsNothingUnlessItIsBlendedTwice) {
  const auto through = [](const char* blend) {
    return principled_value(
        {{"base_color", Vec3(0.5F)}, {"thin", true}, {"metallic", 0.75F}, {"blend", blend}}, kWo,
        kBelow)[0];
  };
  EXPECT_NEAR(through("once"), 0.25F * 0.5F * 0.5F * kInvPi * kWi.z, 1e-6F);
  EXPECT_NEAR(through("twice"), 0.5F * 0.5F * kInvPi * kWi.z, 1e-6F);
}

TEST(Principled, SheenIsOnGlassToo) {
  const auto sheen = [](const char* blend) {
    const auto value = [&](float strength) {
      return principled_value({{"sheen", strength},
                               {"sheen_tint", 0.F},
                               {"specular_transmission", 0.75F},
                               {"metallic", 0.5F},
                               {"blend", blend}},
                              kWo, kWi)[0];
    };
    return value(1.F) - value(0.F);
  };
  const float whole = schlick_weight(half_vector(kWo, kWi).cosine) * kWi.z;
  EXPECT_NEAR(sheen("once"), 0.5F * whole, 1e-6F);
  EXPECT_NEAR(sheen("twice"), 0.5F * 0.25F * whole, 1e-6F) << "on what is opaque alone";
}

TEST(Principled, FlatnessSparesRetroReflectionIfItIsBlendedTwice) {
  const Vec3 wo = direction(75.F, 20.F);
  const Vec3 wi = direction(70.F, 50.F);
  const auto value = [&](float flatness, const char* blend) {
    return principled_value({{"base_color", Vec3(0.5F)},
                             {"roughness", 0.7F},
                             {"flatness", flatness},
                             {"thin", true},
                             {"diffuse_transmission", 0.F},
                             {"blend", blend}},
                            wo, wi)[0];
  };
  const float cos_d = half_vector(wo, wi).cosine;
  const float rr = 2.F * 0.7F * cos_d * cos_d;
  const float fo = schlick_weight(wo.z);
  const float fi = schlick_weight(wi.z);
  const float retro = 0.5F * kInvPi * rr * (fo + fi + fo * fi * (rr - 1.F)) * wi.z;
  ASSERT_GT(retro, 0.01F);
  EXPECT_NEAR(value(0.F, "twice"), value(0.F, "once"), 1e-6F);
  EXPECT_NEAR(value(0.75F, "twice") - value(0.75F, "once"), 0.75F * retro, 1e-5F);
  EXPECT_NEAR(value(1.F, "twice") - value(1.F, "once"), retro, 1e-5F);
}

TEST(Principled, SplitSheetsAreClearAndGlossyOrDiffuse) {
  const auto value = [](float clear, const Vec3& color, const Vec3& wo, const Vec3& wi) {
    return principled_value({{"thin", true},
                             {"sheet", "split"},
                             {"base_color", color},
                             {"specular_transmission", clear},
                             {"diffuse_transmission", 0.5F},
                             {"roughness", 0.6F}},
                            wo, wi)[0];
  };
  const Vec3 black(0.F);
  const Vec3 grey(0.25F);
  const float gloss = principled_value({{"base_color", black}, {"roughness", 0.6F}}, kWo, kWi)[0];
  EXPECT_NEAR(value(0.5F, black, kWo, kWi), 0.5F * gloss, 1e-6F);
  EXPECT_EQ(value(0.F, black, kWo, kWi), 0.F) << "no gloss where nothing is clear";
  EXPECT_NEAR(value(0.5F, grey, -kWo, -kWi), value(0.5F, grey, kWo, kWi), 1e-6F);

  // A quarter of the diffuse light goes through, and all of the clear share but for its gloss.
  const float diffuse = 0.25F * 0.25F * kInvPi * kWi.z;
  EXPECT_NEAR(value(0.F, grey, kWo, kBelow), diffuse, 1e-6F);
  const float alpha = std::pow((0.65F * 1.5F - 0.35F) * 0.6F, 2.F);
  const SheetTransmission sheet{Microfacets(FacetModel::GgxSeparable, alpha, alpha), 1.5F};
  const float clear = 0.25F * sheet.evaluate(kWo, kBelow, true, kRadiance).value[0];
  EXPECT_NEAR(value(0.5F, grey, kWo, kBelow), 0.5F * diffuse + 0.5F * clear, 1e-6F);
}

TEST(Principled, MetalHasTheColourOfTheBaseAtNormalIncidence) {
  Fixture f;
  const auto id = f.add("principled", {{"metallic", 1.F},
                                       {"base_color", f.constant(Spectrum(0.9F, 0.6F, 0.1F))},
                                       {"roughness", 0.3F}});
  const Vec3 up(0.F, 0.F, 1.F);
  const Spectrum value = f.bsdf(id).eval(up, up, kRadiance);
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
    // Every model, with nonsense in place of all that can be textured and each flag on and off.
    for (const bool flags : {false, true}) {
      for (const desc::Model* model : desc::models(desc::ModelKind::Material)) {
        desc::Node node(*model);
        for (const ParameterSpec& spec : model->parameters) {
          if (spec.textured) node.set(spec.name, t);
          if (spec.type == ParameterType::Bool) node.set(spec.name, flags);
          if (spec.type == ParameterType::Material) node.set(spec.name, desc::MaterialRef{0});
        }
        f.add(node);
      }
    }
    f.add("dielectric", {{"eta", t}, {"roughness", t}, {"roughness_v", t}});
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
  const auto id = f.add("conductor", {{"roughness", 0.5F}, {"roughness_v", 0.05F}});
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
  const ReliefFrame bumped = bump_frame(TextureSlot(&ramp), flat_point());
  const Vec3 expected = normalize(Vec3(-0.5F, 0.F, 1.F));
  EXPECT_LT(length(bumped.ns - expected), 1e-3F);
  EXPECT_NEAR(dot(bumped.ns, normalize(bumped.dpdu)), 0.F, 1e-3F);
  Fixture f;
  f.textures.push_back(std::make_unique<Ramp>(0.5F));
  f.scene.materials.resize(2);
  f.scene.materials[0].bump = 0;
  f.scene.materials[0].node = desc::material_node("diffuse");
  f.scene.materials[1].node = mix_of(0, 0);
  EXPECT_LT(length(f.bsdf(0).ns() - expected), 1e-3F);
  EXPECT_LT(length(f.bsdf(1).ns() - expected), 1e-3F);
  EXPECT_EQ(f.bsdf(0).ng(), Vec3(0.F, 0.F, 1.F));
}

TEST(Bump, OfNoHeightKeepsTheNormalsOfASmoothMesh) {
  // A facet of a round mesh: its tangents are in its own plane, not in that of the shading normal.
  SurfacePoint round = flat_point();
  round.ns = normalize(Vec3(0.3F, -0.2F, 1.F));
  const Ramp level(0.F);
  EXPECT_LT(length(bump_frame(TextureSlot(&level), round).ns - round.ns), 1e-6F);
  // What of dp/du is along the shading plane goes up with the slope.
  const Ramp ramp(0.5F);
  const Vec3 u = Vec3(1.F, 0.F, 0.F) - round.ns * round.ns.x;
  const Vec3 v = Vec3(0.F, 1.F, 0.F) - round.ns * round.ns.y;
  const Vec3 expected = normalize(cross(u + round.ns * 0.5F, v));
  EXPECT_LT(length(bump_frame(TextureSlot(&ramp), round).ns - expected), 1e-3F);
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

/// The colour that stands for a vector in a normal map.
TextureSlot code_of(const Vec3& n) {
  const Vec3 c = (n + Vec3(1.F)) * 0.5F;
  return TextureSlot(Spectrum(c.x, c.y, c.z));
}

TEST(NormalMap, TurnsItsVectorsIntoTheFrameOfTheSurface) {
  // A surface whose u runs along y, slanted, and whose v is mirrored: along +x.
  SurfacePoint at = flat_point();
  at.dpdu = {0.F, 2.F, 1.F};
  at.dpdv = {3.F, 0.5F, 0.F};
  const Vec3 n = normalize(Vec3(0.2F, -0.4F, 0.8F));
  const auto ns_of = [&](float strength, bool right_handed) {
    return normal_map_frame(code_of(n), strength, right_handed, at).ns;
  };
  // x of the map is the world's y, z its z, and y the side of v; or z × y = −x whatever v is.
  EXPECT_LT(length(ns_of(1.F, false) - Vec3(n.y, n.x, n.z)), 1e-6F);
  EXPECT_LT(length(ns_of(1.F, true) - Vec3(-n.y, n.x, n.z)), 1e-6F);
  EXPECT_LT(length(ns_of(0.5F, false) - normalize(Vec3(0.5F * n.y, 0.5F * n.x, n.z))), 1e-6F);
  EXPECT_EQ(ns_of(0.F, false), at.ns);
}

TEST(NormalMap, KeepsTheNormalOnItsSideAndWhereItIsNoDirection) {
  const Vec3 up(0.F, 0.F, 1.F);
  const auto ns_of = [](const TextureSlot& normals, const SurfacePoint& at) {
    return normal_map_frame(normals, 1.F, false, at).ns;
  };
  EXPECT_GT(ns_of(code_of({0.6F, 0.F, -0.8F}), flat_point()).z, 0.F);
  EXPECT_EQ(ns_of(code_of({0.F, 0.F, 0.F}), flat_point()), up);
  EXPECT_EQ(ns_of(code_of({1.F, 0.F, 0.F}), flat_point()), up) << "grazing";
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(ns_of(code_of({nan, 0.F, 1.F}), flat_point()), up);
}

TEST(Material, KnowsWhetherItsIndexVaries) {
  Fixture f;
  const auto glass = f.add("dielectric", {{"eta", f.constant(1.4F)}});
  const auto layered = f.add("dielectric", {{"eta", f.ramp(2.F)}});
  const auto uber = f.add("composite", {{"eta", f.ramp(2.F)}});
  f.add(mix_of(glass, layered));
  f.materials = build_materials(f.scene, f.textures, f.warnings);
  const auto varies = [&](desc::MaterialId id) {
    return f.materials[static_cast<std::size_t>(id)]->index_varies;
  };
  EXPECT_FALSE(varies(glass));
  EXPECT_TRUE(varies(layered));
  EXPECT_TRUE(varies(uber));
  EXPECT_TRUE(f.materials.back()->index_varies) << "of one of two";
}

TEST(NormalMap, TiltsWhatAMaterialReflects) {
  Fixture f;
  // The map in a texture: a constant one tilts, too, as a constant bump does not.
  const Vec3 n(0.6F, 0.F, 0.8F);
  f.scene.textures.resize(1);
  f.scene.textures[0].node = desc::texture_node("constant", {{"value", (n + Vec3(1.F)) * 0.5F}});
  f.textures = build_textures(f.scene, f.warnings);
  f.scene.materials.resize(2);
  f.scene.materials[0].normal_map.texture = 0;
  f.scene.materials[0].node = desc::material_node("diffuse", {{"reflectance", Vec3(0.5F)}});
  f.scene.materials[1].node = mix_of(0, 0);
  for (const std::size_t material : {0U, 1U}) {
    EXPECT_LT(length(f.bsdf(material).ns() - n), 1e-6F);
    EXPECT_EQ(f.bsdf(material).ng(), Vec3(0.F, 0.F, 1.F));
    EXPECT_TRUE(f.materials[material]->needs_derivatives());
  }
}

}  // namespace
}  // namespace ajar
