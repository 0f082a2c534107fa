#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene/testing/materials.h"

namespace ajar {
namespace {
using namespace testing;

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

/// f |cos θ_i| of a principled material.
Spectrum principled_value(desc::Node::Given given, const Vec3& wo, const Vec3& wi) {
  Fixture f;
  const desc::MaterialId id = f.add("principled", given);
  return f.bsdf(id).eval(wo, wi, kRadiance);
}
const Vec3 kBelow(kWi.x, kWi.y, -kWi.z);

TEST(Principled, IsTheSameFromBehindUnlessItHasAnInside) {
  const Vec3 wo = direction(60.F, 0.F);
  const Vec3 across = direction(70.F, 170.F);  // beyond the critical angle of glass
  for (const char* blend : {"once", "twice", "layered"}) {
    for (const float metallic : {0.F, 0.5F}) {
      for (const bool thin : {false, true}) {
        const auto value = [&](const Vec3& o, const Vec3& i) {
          return principled_value({{"base_color", Vec3(0.3F)},
                                   {"metallic", metallic},
                                   {"thin", thin},
                                   {"clearcoat", 1.F},
                                   {"coat", 0.5F},
                                   {"coat_roughness", 0.5F},
                                   {"sheen", 1.F},
                                   {"blend", blend}},
                                  o, i)[0];
        };
        EXPECT_FLOAT_EQ(value(-wo, -across), value(wo, across)) << blend << metallic << thin;
        EXPECT_FLOAT_EQ(value(-wo, across), value(wo, -across)) << blend << metallic << thin;
      }
    }
  }
}

TEST(Principled, IsMereGlassFromWithinInItsShare) {
  for (const char* blend : {"once", "twice"}) {
    const auto value = [&](const Vec3& o, const Vec3& i, float share, float metallic,
                           const Vec3& color) {
      return principled_value({{"base_color", color},
                               {"metallic", metallic},
                               {"specular_transmission", share},
                               {"clearcoat", 1.F},
                               {"sheen", 1.F},
                               {"blend", blend}},
                              o, i);
    };
    const Vec3 wo = direction(60.F, 180.F);
    const Vec3 wi = direction(50.F, 10.F);
    const Vec3 white(1.F);
    const float whole = value(-wo, -wi, 1.F, 0.F, white)[0];
    ASSERT_GT(whole, 0.F);
    EXPECT_NEAR(value(-wo, -wi, 0.25F, 0.F, white)[0], 0.25F * whole, 1e-5F * whole) << blend;
    EXPECT_NEAR(value(-wo, -wi, 0.25F, 0.F, Vec3(0.1F))[0], 0.25F * whole, 1e-5F * whole);
    // Metal of Mitsuba lets nothing in, that of pbrt does.
    const float with_metal = value(-wo, -wi, 0.5F, 0.5F, white)[0];
    EXPECT_NEAR(with_metal, (*blend == 'o' ? 0.25F : 0.5F) * whole, 1e-5F * whole) << blend;
  }
}

TEST(Principled, LayersHaveAVarnishWhereItIs) {
  const auto mirror_of = [](const char* blend) {
    Fixture f;
    const desc::MaterialId id =
        f.add("principled", {{"base_color", Vec3(0.F)}, {"coat", 0.5F}, {"blend", blend}});
    float sum = 0.F;
    for (int i = 0; i < 1000; ++i) {
      const auto s = f.bsdf(id).sample(kWo, {(static_cast<float>(i) + 0.5F) / 1000.F, {0.3F, 0.3F}},
                                       kRadiance);
      if (s && s->event().specular() && !s->transmission) sum += s->weight[0] / 1000.F;
    }
    return sum;
  };
  EXPECT_NEAR(mirror_of("layered"), 0.5F * fresnel_dielectric(kWo.z, 1.5F).reflectance, 5e-3F);
  EXPECT_EQ(mirror_of("once"), 0.F);
}

TEST(Principled, LayersAreMetalOrGlossOverAnEvenBase) {
  const auto value = [](float metallic, float strength, const Vec3& wo, const Vec3& wi) {
    return principled_value({{"base_color", Vec3(0.6F)},
                             {"metallic", metallic},
                             {"roughness", 0.7F},
                             {"specular_strength", strength},
                             {"blend", "layered"}},
                            wo, wi)[0];
  };
  EXPECT_NEAR(value(0.F, 0.F, kWo, kWi), 0.6F * kInvPi * kWi.z, 1e-6F);
  const float metal = value(1.F, 1.F, kWo, kWi);
  EXPECT_NEAR(value(0.25F, 1.F, kWo, kWi), 0.25F * metal + 0.75F * value(0.F, 1.F, kWo, kWi),
              1e-6F);
  EXPECT_EQ(principled_value({{"specular_transmission", 1.F}, {"blend", "layered"}}, kWo, kBelow),
            Spectrum(0.F));
}

TEST(Principled, ThinSheetsTransmitDiffusely) {
  Fixture f;
  const auto id = f.add(
      "principled",
      {{"thin", true}, {"diffuse_transmission", f.constant(1.2F)}, {"base_color", Vec3(0.7F)}});
  const Vec3 below(kWi.x, kWi.y, -kWi.z);
  EXPECT_NEAR(f.bsdf(id).eval(kWo, below, kRadiance)[0], 0.6F * 0.7F * kInvPi * kWi.z, 1e-5F);
}

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

TEST(Principled, MetalAndGlassTransmitNothingDiffusely) {
  const auto through = [](const char* blend) {
    return principled_value(
        {{"base_color", Vec3(0.5F)}, {"thin", true}, {"metallic", 0.75F}, {"blend", blend}}, kWo,
        kBelow)[0];
  };
  for (const char* blend : {"once", "twice"}) {
    EXPECT_NEAR(through(blend), 0.25F * 0.5F * 0.5F * kInvPi * kWi.z, 1e-6F);
  }
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
                             {"specular_strength", 0.F},
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

}  // namespace
}  // namespace ajar
