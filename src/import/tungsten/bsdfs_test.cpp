#include "import/tungsten/bsdfs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "import/tungsten/coat_optics.h"
#include "import/tungsten/import_test_support.h"

namespace ajar::tungsten {
namespace {

/// Imports a bsdf that is a warning.
desc::SceneDesc scene_with_warning(const std::string& bsdfs, const std::string& expected) {
  const std::string text = scene_text(bsdfs, "{'type': 'sphere', 'bsdf': 'm'}");
  Warnings warnings;
  desc::SceneDesc scene = import_with(text, warnings);
  EXPECT_TRUE(contains(warnings_of(text), expected)) << warnings_of(text);
  return scene;
}

TEST(Bsdfs, DiffuseOnes) {
  const desc::SceneDesc lambert = scene_with_bsdf("'type': 'lambert', 'albedo': 0.3");
  EXPECT_TRUE(material_of(lambert).is("diffuse"));
  EXPECT_EQ(material_of(lambert).color("reflectance"), Vec3(0.3F));
  const desc::SceneDesc rough = scene_with_bsdf("'type': 'oren_nayar', 'roughness': 0.5");
  // σ = roughness / √2 radians.
  EXPECT_NEAR(material_of(rough).number("sigma"), 0.5F * 0.70710678F * 180.F / kPi, 1e-4F);
  EXPECT_EQ(material_of(scene_with_bsdf("'type': 'null'")).color("reflectance"), Vec3(0.F));
  EXPECT_TRUE(material_of(scene_with_bsdf("'type': 'forward'")).is("interface"));
  const desc::SceneDesc leaf =
      scene_with_bsdf("'type': 'diffuse_transmission', 'albedo': 0.8, 'transmittance': 0.5");
  EXPECT_EQ(material_of(leaf).color("diffuse"), Vec3(0.8F));
  const desc::SceneDesc other = scene_with_warning(
      "{'name': 'm', 'type': 'diffuse_transmission', 'transmittance': 0.25}",
      "test.json:2:11#/bsdfs/0: Tungsten does not read \"transmittance\" and transmits half");
  for (const desc::SceneDesc* scene : {&leaf, &other}) {
    EXPECT_EQ(material_of(*scene).color("reflectance"), Vec3(0.5F));
    EXPECT_EQ(material_of(*scene).color("transmittance"), Vec3(0.5F));
  }
}

TEST(Bsdfs, MetalsGoByNameOrByNumbers) {
  const desc::SceneDesc gold = scene_with_bsdf(
      "'type': 'rough_conductor', 'material': 'Au', 'roughness': 0.2, 'distribution': 'beckmann'");
  expect_near(material_of(gold).color("eta"), {0.143119F, 0.374957F, 1.44248F});
  expect_near(material_of(gold).color("k"), {3.98316F, 2.38572F, 1.60322F});
  EXPECT_EQ(material_of(gold).number("roughness"), 0.2F);
  EXPECT_EQ(material_of(gold).text("distribution"), "beckmann");
  EXPECT_EQ(material_of(gold).text("masking"), "separable");
  const desc::SceneDesc given = scene_with_bsdf("'type': 'conductor', 'eta': [1, 2, 3], 'k': 4");
  EXPECT_EQ(material_of(given).color("eta"), Vec3(1.F, 2.F, 3.F));
  EXPECT_EQ(material_of(given).color("k"), Vec3(4.F));
  EXPECT_EQ(material_of(given).number("roughness"), 0.F);
  scene_with_warning("{'name': 'm', 'type': 'conductor', 'material': 'Aux'}",
                     "test.json:2:11#/bsdfs/0: unknown metal \"Aux\"; did you mean \"Au\"?");
  scene_with_warning("{'name': 'm', 'type': 'rough_conductor', 'distribution': 'phong'}",
                     "\"beckmann\", which is near, stands in");
}

TEST(Bsdfs, ATintIsABlendWithBlack) {
  const desc::SceneDesc scene = scene_with_bsdf("'type': 'conductor', 'albedo': [1, 0.5, 0.25]");
  const desc::Node& mix = material_of(scene);
  ASSERT_TRUE(mix.is("mix"));
  EXPECT_EQ(mix.color("amount"), Vec3(1.F, 0.5F, 0.25F));
  EXPECT_TRUE(part_of(scene, mix, "first").is("conductor"));
  EXPECT_EQ(part_of(scene, mix, "second").color("reflectance"), Vec3(0.F));
}

TEST(Bsdfs, Glass) {
  const desc::SceneDesc glass = scene_with_bsdf("'type': 'dielectric', 'ior': 1.33");
  EXPECT_EQ(material_of(glass).number("eta"), 1.33F);
  EXPECT_EQ(material_of(glass).number("roughness"), 0.F);
  EXPECT_EQ(material_of(glass).color("transmittance"), Vec3(1.F));
  const desc::SceneDesc opaque =
      scene_with_bsdf("'type': 'dielectric', 'enable_refraction': false");
  EXPECT_EQ(material_of(opaque).color("transmittance"), Vec3(0.F));
  EXPECT_EQ(material_of(scene_with_bsdf("'type': 'rough_dielectric'")).number("roughness"), 0.1F);
  const desc::SceneDesc sheet = scene_with_bsdf("'type': 'thinsheet', 'sigma_a': 2");
  EXPECT_TRUE(material_of(sheet).flag("thin"));
  expect_near(material_of(sheet).color("transmittance"), Vec3(std::exp(-2.F)));
  EXPECT_TRUE(material_of(sheet).flag("along_normal"));
  EXPECT_TRUE(material_of(sheet).flag("polarised"));
  scene_with_warning("{'name': 'm', 'type': 'thinsheet', 'sigma_a': 2, 'thickness': 'a.png'}",
                     "test.json:2:11#/bsdfs/0: a texture of \"thickness\" is not supported");
  // Without absorption the thickness does not matter.
  scene_with_bsdf("'type': 'thinsheet', 'thickness': 'a.png'");
}

TEST(Bsdfs, MixturesReferToOthersOfBothKinds) {
  const desc::SceneDesc scene = scene_of(
      "{'name': 'm', 'type': 'mixed', 'ratio': 0.75, 'bsdf0': 'later', 'bsdf1': {'type': "
      "'mirror'}},"
      "{'name': 'later', 'type': 'lambert', 'albedo': 0.1}",
      "{'type': 'sphere', 'bsdf': 'm'}");
  const desc::Node& mix = material_of(scene);
  EXPECT_EQ(mix.color("amount"), Vec3(0.75F));
  EXPECT_EQ(part_of(scene, mix, "first").color("reflectance"), Vec3(0.1F));
  EXPECT_TRUE(part_of(scene, mix, "second").is("mirror"));
}

TEST(Bsdfs, OpacityCutsOrBlends) {
  const desc::SceneDesc half =
      scene_with_bsdf("'type': 'transparency', 'alpha': 0.5, 'base': {'type': 'conductor'}");
  EXPECT_EQ(material_of(half).color("amount"), Vec3(0.5F));
  EXPECT_TRUE(part_of(half, material_of(half), "first").is("conductor"));
  EXPECT_EQ(part_of(half, material_of(half), "second").color("opacity"), Vec3(0.F));
  EXPECT_EQ(half.shapes.at(0).alpha, desc::kNone);
  EXPECT_TRUE(material_of(scene_with_bsdf("'type': 'transparency', 'alpha': 0")).is("interface"));
  const desc::SceneDesc leaf =
      scene_with_bsdf("'type': 'transparency', 'alpha': 'a.png', 'base': {'type': 'mirror'}");
  EXPECT_EQ(scene_with_bsdf("'type': 'transparency', 'alpha': 'a.exr', 'base': {'type': 'mirror'}")
                .textures.back()
                .node.text("channel"),
            "alpha_or_mean");
  EXPECT_TRUE(part_of(leaf, material_of(leaf), "first").is("mirror"));
  const desc::TextureId alpha = leaf.shapes.at(0).alpha;
  const desc::Node& image = leaf.textures.at(static_cast<std::size_t>(alpha)).node;
  EXPECT_EQ(image.text("channel"), "alpha");
  EXPECT_EQ(image.number("decoding_exponent"), 1.F);
  EXPECT_EQ(material_of(leaf).texture("amount"), alpha);
}

TEST(Bsdfs, ForwardInAMixLetsLightPass) {
  const desc::SceneDesc scene =
      scene_with_bsdf("'type': 'mixed', 'bsdf0': {'type': 'forward'}, 'bsdf1': {'type': 'mirror'}");
  const desc::Node clear = part_of(scene, material_of(scene), "first");
  ASSERT_TRUE(clear.is("composite"));
  EXPECT_EQ(clear.color("opacity"), Vec3(0.F));
}

TEST(Bsdfs, OnlyTheWholeHasABump) {
  // In Tungsten the surface asks the bsdf that it has, and no part of it.
  const std::string parts =
      "'type': 'mixed', 'bsdf0': 'bumpy', 'bsdf1': {'type': 'transparency', 'base': 'bumpy'}},"
      "{'name': 'bumpy', 'type': 'lambert', 'bump': 'b.png'}";
  const auto material = [](const desc::SceneDesc& scene, desc::MaterialId id) {
    return scene.materials.at(static_cast<std::size_t>(id));
  };
  const desc::SceneDesc flat =
      scene_with_warning("{'name': 'm', " + parts, "the height of \"bump\"");
  const desc::SceneDesc bumpy =
      scene_with_warning("{'name': 'm', 'bump': 'c.png', " + parts, "the height of \"bump\"");
  EXPECT_FALSE(material(flat, flat.shapes.at(0).material).has_relief());
  EXPECT_TRUE(material(bumpy, bumpy.shapes.at(0).material).has_relief());
  for (const desc::SceneDesc* scene : {&flat, &bumpy}) {
    for (const char* part : {"first", "second"}) {
      EXPECT_FALSE(material(*scene, material_of(*scene).material(part)).has_relief()) << part;
    }
    EXPECT_EQ(std::count_if(scene->materials.begin(), scene->materials.end(),
                            [](const desc::Material& m) { return m.has_relief(); }),
              scene == &flat ? 1 : 2)
        << "what has the name alone keeps its own";
  }
}

TEST(Bsdfs, FullOpacityLeavesTheBase) {
  const std::string bsdfs =
      "{'name': 'm', 'type': 'transparency', 'base': 'n', 'bump': 'b.png'},"
      "{'name': 'n', 'type': 'lambert'}";
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      scene_text(bsdfs, "{'type': 'sphere', 'bsdf': 'm'}, {'type': 'cube', 'bsdf': 'n'}"),
      warnings);
  const auto has_relief = [&](std::size_t shape) {
    return scene.materials.at(static_cast<std::size_t>(scene.shapes.at(shape).material))
        .has_relief();
  };
  EXPECT_TRUE(has_relief(0));
  EXPECT_FALSE(has_relief(1));
}

TEST(Bsdfs, MediaOfPartsAreWarnings) {
  for (const char* whole :
       {"'type': 'mixed', 'bsdf1': {'type': 'null'}, 'bsdf0'", "'type': 'transparency', 'base'",
        "'type': 'rough_coat', 'substrate'"}) {
    const desc::SceneDesc scene = scene_with_warning(
        "{'name': 'm', 'ext_medium': {'type': 'homogeneous', 'sigma_a': 2}, " + std::string(whole) +
            ": {'type': 'lambert', 'int_medium': {'type': 'homogeneous', 'sigma_a': 1}}}",
        "the media of a part of a bsdf are ignored");
    EXPECT_EQ(scene.shapes.at(0).inside, desc::kNone) << whole;
    ASSERT_NE(scene.shapes.at(0).outside, desc::kNone) << whole;
    EXPECT_EQ(scene.media.at(static_cast<std::size_t>(scene.shapes[0].outside)).sigma_a, Vec3(2.F));
  }
}

TEST(Bsdfs, OpacityOfPartsIsKept) {
  const desc::SceneDesc scene = scene_with_bsdf(
      "'type': 'mixed', 'bsdf0': {'type': 'transparency', 'alpha': 'a.png'}, 'bsdf1': {'type': "
      "'mirror'}");
  const desc::Node part = part_of(scene, material_of(scene), "first");
  ASSERT_TRUE(part.is("mix"));
  EXPECT_NE(part.texture("amount"), desc::kNone);
  EXPECT_EQ(scene.shapes.at(0).alpha, desc::kNone) << "the other part is not cut away";
}

TEST(Bsdfs, PlasticIsACoatedBase) {
  const desc::Node plastic =
      material_of(scene_with_bsdf("'type': 'plastic', 'ior': 1.4, 'albedo': [0.5, 0.2, 1]"));
  ASSERT_TRUE(plastic.is("coated_diffuse"));
  EXPECT_EQ(plastic.text("coat"), "dielectric");
  EXPECT_FLOAT_EQ(plastic.number("eta"), 1.4F);
  EXPECT_EQ(plastic.number("roughness"), 0.F);
  EXPECT_EQ(plastic.text("inner_reflections"), "base");
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(plastic.color("diffuse_reflectance")[i], Vec3(0.5F, 0.2F, 1.F)[i], 1e-6F);
  }
  const desc::Node rough =
      material_of(scene_with_bsdf("'type': 'rough_plastic', 'roughness': 0.25, 'albedo': 'a.png'"));
  EXPECT_EQ(rough.number("roughness"), 0.25F);
  EXPECT_NE(rough.texture("diffuse_reflectance"), desc::kNone);
  EXPECT_EQ(rough.text("masking"), "separable");
  EXPECT_EQ(rough.text("coat_transmission"), "smooth");
  const desc::Node beckmann =
      material_of(scene_with_bsdf("'type': 'rough_plastic', 'distribution': 'beckmann'"));
  EXPECT_EQ(beckmann.text("distribution"), "beckmann");
}

TEST(Bsdfs, LayersThinnerThanAirHaveNoGlossWithAWarning) {
  scene_with_warning("{'name': 'm', 'type': 'plastic', 'ior': 0.8}", "an \"ior\" below 1");
}

TEST(Bsdfs, LayersThatAbsorbDoSoStraightOn) {
  const desc::Node node = material_of(
      scene_with_bsdf("'type': 'plastic', 'albedo': 'a.png', 'sigma_a': 0.3, 'thickness': 2"));
  EXPECT_EQ(node.get("coat_depth"), desc::Value(Vec3(0.6F)));
  EXPECT_EQ(node.text("coat_ways"), "straight");
}

TEST(Bsdfs, CoatsOnMatteAndMetalAreLayers) {
  const desc::Node wood = material_of(scene_with_bsdf(
      "'type': 'rough_coat', 'roughness': 0.2, 'substrate': {'type': 'lambert', 'albedo': 0.5}"));
  ASSERT_TRUE(wood.is("coated_diffuse"));
  EXPECT_FLOAT_EQ(wood.number("eta"), 1.3F);
  EXPECT_EQ(wood.number("roughness"), 0.2F);
  EXPECT_EQ(wood.integer("bounces"), 1);
  const desc::Node lacquer = material_of(
      scene_with_bsdf("'type': 'smooth_coat', 'ior': 1.5, 'sigma_a': [0, 1, 2], 'thickness': 0.5, "
                      "'substrate': {'type': 'conductor', 'eta': [2, 2, 2], 'k': [4, 4, 4]}"));
  ASSERT_TRUE(lacquer.is("coated_conductor"));
  EXPECT_EQ(lacquer.color("eta"), Vec3(3.F));
  EXPECT_EQ(lacquer.number("roughness"), 0.F);
  EXPECT_EQ(lacquer.number("coat_roughness"), 0.F);
  EXPECT_EQ(lacquer.integer("bounces"), 1);
  EXPECT_EQ(lacquer.get("coat_depth"), desc::Value(Vec3(0.F, 0.5F, 1.F)));
}

TEST(Bsdfs, TheCoatOfABlendReflectsAsMuchAsTheLayer) {
  const desc::SceneDesc scene = scene_with_warning(
      "{'name': 'm', 'type': 'smooth_coat', 'ior': 1.7, 'thickness': 5, 'sigma_a': [0.1, 0.2, "
      "0.5], "
      "'substrate': {'type': 'mixed', 'bsdf0': {'type': 'rough_conductor'}, 'bsdf1': {'type': "
      "'rough_conductor'}}}",
      "a coat of this is not supported");
  const desc::Node& mix = material_of(scene);
  const desc::Node& coat = part_of(scene, mix, "first");
  EXPECT_TRUE(part_of(scene, mix, "second").is("mix"));
  const double of_coat = mean_reflectance(static_cast<double>(coat.number("eta")));
  for (int i = 0; i < 3; ++i) {
    const auto share = static_cast<double>(mix.color("amount")[i]);
    EXPECT_NEAR(share * of_coat * static_cast<double>(coat.color("mirror_reflectance")[i]),
                mean_reflectance(1.7), 1e-4);
    const double tau = 5.0 * static_cast<double>(Vec3(0.1F, 0.2F, 0.5F)[i]);
    EXPECT_NEAR(1.0 - share, mean_round_trip(1.7, tau), 1e-5);
  }
}

TEST(Bsdfs, StandInsForTheRest) {
  EXPECT_TRUE(material_of(scene_with_warning("{'name': 'm', 'type': 'hair'}", "bsdfs of fibers"))
                  .is("diffuse"));
  EXPECT_TRUE(material_of(scene_with_warning("{'name': 'm', 'type': 'phong', 'exponent': 100}",
                                             "Phong's bsdf"))
                  .is("coated_diffuse"));
  EXPECT_TRUE(material_of(scene_with_warning("{'name': 'm', 'type': 'lamberd'}",
                                             "unknown bsdf type \"lamberd\"; did you mean "
                                             "\"lambert\"?"))
                  .is("diffuse"));
}

TEST(Bsdfs, NamesThatLeadNowhereAreWarnings) {
  scene_with_warning("{'name': 'n', 'type': 'mirror'}",
                     "test.json:3:43#/primitives/0/bsdf: unknown bsdf \"m\"; did you mean \"n\"?");
  scene_with_warning("{'name': 'm', 'type': 'mirror'}, {'name': 'm', 'type': 'null'}",
                     "another bsdf \"m\" before, which counts");
  scene_with_warning("{'name': 'm', 'type': 'mixed', 'bsdf0': 'm', 'bsdf1': 'm'}",
                     "refers to itself");
  scene_with_warning("{'name': 'm', 'type': 'mixed'}", "\"bsdf0\" is missing");
}

TEST(Bsdfs, LongChainsOfNamesEnd) {
  std::string bsdfs;
  for (int i = 0; i < 2000; ++i) {
    bsdfs += "{'name': '" + std::string(i == 0 ? "m" : std::to_string(i)) +
             "', 'type': 'mixed', 'bsdf0': '" + std::to_string(i + 1) +
             "', 'bsdf1': {'type': 'null'}},";
  }
  scene_with_warning(bsdfs + "{'name': '2000', 'type': 'mirror'}", "too many others in a row");
}

}  // namespace
}  // namespace ajar::tungsten
