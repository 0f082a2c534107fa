#include "scene/material/material.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene/testing/materials.h"

namespace ajar {
namespace {
using namespace testing;

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

/// Mixtures of diffuse materials do not claim to be diffuse.
TEST(Materials, ReportWhetherTheyAreDiffuse) {
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

TEST(Materials, NodesWithoutAModelAreLocatedErrors) {
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
  // Equal directions; only the masking differs. Source: Heitz 2014, equations 23 and 99, with Λ of
  // both directions alike.
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

TEST(Dielectric, OfIndexOneIsAnInterfaceUnlessItTints) {
  Fixture f;
  const auto is_interface = [&](const desc::Node& node) {
    const auto id = f.add(node);
    EXPECT_FALSE(f.bsdf(id).empty()) << "a light on it still shows it";
    return f.materials[id]->is_interface();
  };
  // 1.000277, that of air, over itself may be rounded.
  for (const float eta : {1.F, 1.F + 0x1p-23F, 1.F - 0x1p-24F}) {
    for (const bool thin : {false, true}) {
      EXPECT_TRUE(is_interface(desc::material_node("dielectric", {{"eta", eta}, {"thin", thin}})));
    }
    EXPECT_TRUE(is_interface(
        desc::material_node("dielectric", {{"eta", eta}, {"reflectance", Vec3(0.3F)}})));
    EXPECT_TRUE(
        is_interface(desc::material_node("dielectric", {{"eta", eta}, {"roughness", 0.3F}})));
    EXPECT_FALSE(is_interface(
        desc::material_node("dielectric", {{"eta", eta}, {"transmittance", Vec3(1, 1, 0.9F)}})));
  }
  EXPECT_FALSE(is_interface(desc::material_node("dielectric", {{"eta", 1.0003F}})));
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

TEST(Material, ReportsWhetherItsIndexVaries) {
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

}  // namespace
}  // namespace ajar
