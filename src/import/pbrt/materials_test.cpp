// Materials, spectra and textures: pbrt-v3's defaults and meanings.
#include <gtest/gtest.h>

#include "color/color.h"
#include "core/spectrum.h"
#include "import/common/metals.h"
#include "import/pbrt/import_test_support.h"
#include "scene/desc/models.h"

namespace ajar {
namespace {

TEST(PbrtMaterials, HaveTheDefaultsOfPbrt) {
  {
    const desc::Node m = material_of("");
    EXPECT_TRUE(m.is("diffuse"));
    EXPECT_EQ(m.color("reflectance"), desc::Rgb(0.5F));
    EXPECT_EQ(m.number("sigma"), 0.F);
  }
  {
    const desc::Node m = material_of("Material \"glass\"");
    EXPECT_TRUE(m.is("dielectric"));
    EXPECT_EQ(m.color("reflectance"), desc::Rgb(1.F));
    EXPECT_EQ(m.color("transmittance"), desc::Rgb(1.F));
    EXPECT_EQ(m.number("eta"), 1.5F);
    EXPECT_EQ(m.number("roughness"), 0.F);
    EXPECT_EQ(m.number("roughness_v"), 0.F);
    EXPECT_EQ(m.text("roughness_scale"), "log");
    EXPECT_FALSE(m.flag("thin"));
  }
  {
    const desc::Node m =
        material_of("Material \"uber\" \"float roughness\" .3 \"float vroughness\" .4");
    EXPECT_TRUE(m.is("composite"));
    EXPECT_EQ(m.color("diffuse_reflectance"), desc::Rgb(0.25F));
    EXPECT_EQ(m.color("glossy_reflectance"), desc::Rgb(0.25F));
    EXPECT_EQ(m.color("mirror_reflectance"), desc::Rgb(0.F));
    EXPECT_EQ(m.color("transmittance"), desc::Rgb(0.F));
    EXPECT_EQ(m.color("opacity"), desc::Rgb(1.F));
    EXPECT_EQ(m.number("roughness"), 0.3F);
    EXPECT_EQ(m.number("roughness_v"), 0.4F);
  }
  {
    EXPECT_EQ(material_of("Material \"disney\"").text("blend"), "twice");
    const desc::Node m = material_of("Material \"disney\" \"color color\" [.1 .2 .3]");
    EXPECT_TRUE(m.is("principled"));
    EXPECT_EQ(m.color("base_color"), desc::Rgb(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(m.number("roughness"), 0.5F);
    EXPECT_EQ(m.number("sheen_tint"), 0.5F);
    EXPECT_EQ(m.number("clearcoat_gloss"), 1.F);
    EXPECT_EQ(m.number("diffuse_transmission"), 1.F);
  }
  {
    const desc::Node m = material_of("Material \"translucent\"");
    EXPECT_EQ(m.color("diffuse"), desc::Rgb(0.25F));
    EXPECT_EQ(m.color("reflectance"), desc::Rgb(0.5F));
    EXPECT_EQ(m.number("roughness"), 0.1F);
  }
  {
    const desc::Node m = material_of("Material \"substrate\" \"float uroughness\" .2");
    EXPECT_TRUE(m.is("coated_diffuse"));
    EXPECT_EQ(m.color("diffuse_reflectance"), desc::Rgb(0.5F));
    EXPECT_EQ(m.number("roughness"), 0.2F);
    EXPECT_EQ(m.number("roughness_v"), 0.1F);
  }
  EXPECT_EQ(material_of("Material \"mirror\"").color("reflectance"), desc::Rgb(0.9F));
  EXPECT_EQ(material_of("Material \"plastic\"").color("diffuse_reflectance"), desc::Rgb(0.25F));
}

TEST(PbrtMaterials, RoughnessIsTheFacetsAlphaIfItIsNotRemapped) {
  const desc::Node m = material_of("Material \"plastic\" \"bool remaproughness\" \"false\"");
  EXPECT_EQ(m.text("roughness_scale"), "alpha");
}

TEST(PbrtMaterials, IndexIsAnotherNameOfEta) {
  EXPECT_EQ(material_of("Material \"glass\" \"float index\" 1.3").number("eta"), 1.3F);
  // Parameters without effect are reported.
  EXPECT_TRUE(
      contains(warnings_of(world("Material \"glass\" \"float index\" 1.3 \"float eta\" 1.4")),
               "unused parameter \"float index\""));
}

TEST(PbrtMaterials, MetalIsCopperByDefault) {
  // The RGB constants of copper that exporters compute from the same measurements (veach-mis
  // scene).
  const desc::Node m = material_of("Material \"metal\"");
  EXPECT_TRUE(m.is("conductor"));
  expect_rgb(m.color("eta"), {0.200438F, 0.924033F, 1.102212F}, 0.01F);
  expect_rgb(m.color("k"), {3.912949F, 2.452848F, 2.142188F}, 0.02F);
  expect_rgb(m.color("eta"), desc::Rgb(*metal_rgb("Cu", MetalQuantity::Eta)));
  expect_rgb(m.color("k"), desc::Rgb(*metal_rgb("Cu", MetalQuantity::K)));
  EXPECT_EQ(m.number("roughness"), 0.01F);
  EXPECT_EQ(m.get("roughness_v"), m.get("roughness"));
  EXPECT_EQ(m.text("distribution"), "ggx");
  EXPECT_EQ(
      material_of("Material \"metal\" \"string distribution\" \"beckmann\"").text("distribution"),
      "beckmann");
  EXPECT_TRUE(
      contains(error_of(world("Material \"metal\" \"string distribution\" \"beckman\"")),
               "2:1: unknown value of \"distribution\" \"beckman\"; did you mean \"beckmann\"?"));
}

TEST(PbrtMaterials, MetalsAreKnownByNameUnlessTheFileExists) {
  const desc::Rgb gold_eta(*metal_rgb("Au", MetalQuantity::Eta));
  const desc::Rgb gold_k(*metal_rgb("Au", MetalQuantity::K));
  EXPECT_GT(gold_k.x, gold_k.z);
  for (const auto& [eta, k] : {std::pair("spds/metals/Au.eta.spd", "spds/metals/Au.k.spd"),
                               std::pair("metal-Au-eta", "metal-Au-k")}) {
    const desc::Node m = material_of("Material \"metal\" \"spectrum eta\" \"" + std::string(eta) +
                                     "\" \"spectrum k\" [\"" + k + "\"]");
    expect_rgb(m.color("eta"), gold_eta);
    expect_rgb(m.color("k"), gold_k);
  }
  const desc::SceneDesc s = scene_of("Material \"metal\" \"spectrum eta\" \"Au.eta.spd\"",
                                     {{"Au.eta.spd", "# mine\n400 2\n700 2\n"}});
  const desc::Rgb mine = s.materials[0].node.color("eta");
  EXPECT_NEAR(luminance({mine.x, mine.y, mine.z}), 2.F, 1e-3F);
}

TEST(PbrtMaterials, ANumberMoreThanPairsInASpectrumIsIgnoredWithAWarning) {
  const std::string body = "Material \"matte\" \"spectrum Kd\" \"a.spd\"";
  const auto color = [&](const std::string& file) {
    Warnings warnings;
    const desc::SceneDesc scene = import_with(world(body), warnings, {{"a.spd", file}});
    return std::pair(material_node_of(scene, scene.shapes.back()).color("reflectance"),
                     lines_of(warnings));
  };
  const auto [even, nothing] = color("300 .5 500 .25 800 .5");
  EXPECT_EQ(nothing, "");
  const auto [odd, warning] = color("300 .5 500 .25\n800 .5 900");
  expect_rgb(odd, even);
  EXPECT_TRUE(contains(warning, "a.spd:2:8: this spectrum has a number more")) << warning;
}

TEST(PbrtMaterials, MissingSpectraAreWarningsWithTheDefault) {
  const std::string warning =
      warnings_of(world("Material \"matte\" \"spectrum Kd\" \"nothing.spd\""));
  EXPECT_TRUE(contains(warning, "test.pbrt:2:18: spectrum \"nothing.spd\" cannot be used"))
      << warning;
  EXPECT_TRUE(contains(
      warnings_of(world("Material \"matte\" \"spectrum Kd\" \"a.spd\""), {{"a.spd", "400 x"}}),
      "a.spd:1:5"));
}

TEST(PbrtMaterials, NamedOnesAreScopedAndMixed) {
  const desc::SceneDesc s = scene_of(
      "MakeNamedMaterial \"a\" \"string type\" \"mirror\" "
      "AttributeBegin MakeNamedMaterial \"a\" \"string type\" \"plastic\" NamedMaterial \"a\" "
      "Shape \"disk\" AttributeEnd "
      "MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string namedmaterial1\" \"a\" \"string "
      "namedmaterial2\" \"a\" "
      "NamedMaterial \"m\"");
  EXPECT_TRUE(material_node_of(s, s.shapes[0]).is("plastic"));
  const desc::Node& mix = material_node_of(s, s.shapes[1]);
  for (const char* part : {"first", "second"}) {
    EXPECT_TRUE(s.materials.at(static_cast<std::size_t>(mix.material(part))).node.is("mirror"));
  }
  EXPECT_EQ(mix.color("amount"), desc::Rgb(0.5F));
  const std::string misspelt =
      "MakeNamedMaterial \"glas\" \"string type\" \"glass\" NamedMaterial \"glass\"";
  EXPECT_TRUE(contains(warnings_of(world(misspelt)),
                       "unknown named material \"glass\"; did you mean \"glas\"?"));
  Warnings warnings;
  const desc::SceneDesc unknown = import_with(world(misspelt), warnings);
  EXPECT_EQ(material_node_of(unknown, unknown.shapes.at(0)), desc::material_node("diffuse"));
  EXPECT_TRUE(contains(error_of("WorldBegin MakeNamedMaterial \"x\""), "needs \"string type\""));
  EXPECT_TRUE(contains(error_of("WorldBegin Material \"mix\""),
                       "a mix material needs \"string namedmaterial1\""));
}

TEST(PbrtMaterials, EmptyAndNoneAreInterfaces) {
  EXPECT_TRUE(material_of("Material \"\"").is("interface"));
  EXPECT_TRUE(material_of("Material \"none\"").is("interface"));
  EXPECT_TRUE(material_of("MakeNamedMaterial \"x\" \"string type\" \"none\" NamedMaterial \"x\"")
                  .is("interface"));
}

TEST(PbrtMaterials, ShapesMayOverrideParameters) {
  for (const char* set : {"Material \"plastic\" \"rgb Kd\" [.1 .2 .3]",
                          "MakeNamedMaterial \"p\" \"string type\" \"plastic\" \"rgb Kd\" [.1 .2 "
                          ".3] NamedMaterial \"p\""}) {
    const desc::SceneDesc s =
        scene_of(std::string(set) +
                 " Shape \"disk\" \"rgb Kd\" [.9 .8 .7] Shape \"disk\" \"float radius\" 2");
    EXPECT_EQ(material_node_of(s, s.shapes[0]).color("diffuse_reflectance"),
              desc::Rgb(0.9F, 0.8F, 0.7F));
    EXPECT_EQ(material_node_of(s, s.shapes[1]).color("diffuse_reflectance"),
              desc::Rgb(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(s.shapes[1].material, s.shapes[2].material);
  }
}

TEST(PbrtMaterials, UnsupportedOnesHaveStandIns) {
  for (const char* type : {"fourier", "hair", "subsurface", "kdsubsurface"}) {
    const std::string warning = warnings_of(world("Material \"" + std::string(type) + "\""));
    EXPECT_TRUE(contains(warning, "matte one stands in")) << warning;
  }
  Warnings warnings;
  const desc::SceneDesc hair =
      import_with(world("Material \"hair\" \"rgb color\" [.1 .2 .3]"), warnings);
  EXPECT_EQ(hair.materials[0].node,
            desc::material_node("diffuse", {{"reflectance", desc::Rgb(0.1F, 0.2F, 0.3F)}}));
  EXPECT_TRUE(contains(error_of(world("Material \"mate\"")),
                       "unknown material \"mate\"; did you mean \"matte\"?"));
  // Ours that pbrt calls otherwise do not go by our names, which may be pbrt-v4's.
  EXPECT_TRUE(contains(error_of(world("Material \"dielectric\"")), "belongs to pbrt-v4"));
  EXPECT_TRUE(contains(error_of(world("Material \"composite\"")), "unknown material"));
}

TEST(PbrtMaterials, BelowTheSurfaceLightIsTintedWhereItEnters) {
  const auto stand_in = [](const std::string& type_and_parameters) {
    Warnings warnings;
    const desc::SceneDesc s = import_with(
        world("Texture \"t\" \"spectrum\" \"uv\" Material " + type_and_parameters), warnings);
    EXPECT_EQ(warnings.count(), 1U) << warnings.messages().back();
    return s;
  };
  const std::string tints = "\"rgb Kr\" [.5 .6 .7] \"rgb Kt\" [.1 .2 .3] ";
  const desc::SceneDesc tinted =
      stand_in("\"kdsubsurface\" \"rgb Kd\" [.8 .8 .8] \"rgb mfp\" [1 1 1] " + tints);
  const desc::Node& node = tinted.materials[0].node;
  EXPECT_EQ(node.color("coat_reflectance"), desc::Rgb(0.5F, 0.6F, 0.7F));
  expect_rgb(node.color("diffuse_reflectance"), {0.08F, 0.16F, 0.24F});
  EXPECT_EQ(stand_in("\"kdsubsurface\"").materials[0].node.color("diffuse_reflectance"),
            desc::Rgb(0.5F));
  const desc::SceneDesc textured =
      stand_in("\"kdsubsurface\" \"texture Kd\" \"t\" \"rgb Kt\" [.1 .2 .3]");
  const desc::Node& product =
      textured.textures
          .at(static_cast<std::size_t>(textured.materials[0].node.texture("diffuse_reflectance")))
          .node;
  EXPECT_EQ(product.texture("first"), 0);
  EXPECT_EQ(product.color("second"), desc::Rgb(0.1F, 0.2F, 0.3F));
  // A preset fills in missing coefficients.
  const auto color = [&](const std::string& parameters) {
    return stand_in("\"subsurface\" \"string name\" \"Ketchup\" " + parameters)
        .materials[0]
        .node.color("diffuse_reflectance");
  };
  EXPECT_EQ(color("\"rgb sigma_s\" [0 0 0]"), desc::Rgb(0.F));
  EXPECT_LT(color("\"rgb sigma_a\" [99 99 99]").x, color("").x);
}

TEST(PbrtMaterials, SubsurfaceScatteringIsNotSupported) {
  EXPECT_TRUE(contains(warnings_of(world("Material \"disney\" \"rgb scatterdistance\" [0 0 .1]")),
                       "\"scatterdistance\" (subsurface scattering) is not supported"));
  material_of("Material \"disney\" \"rgb scatterdistance\" [0 0 0]");
}

TEST(PbrtMaterials, BumpMapsAreFloatTextures) {
  const desc::SceneDesc s =
      scene_of("Texture \"b\" \"float\" \"fbm\" Material \"matte\" \"texture bumpmap\" \"b\"");
  EXPECT_TRUE(s.textures.at(static_cast<std::size_t>(s.materials[0].bump)).node.is("fbm"));
  EXPECT_EQ(scene_of("Material \"matte\" \"float bumpmap\" .1").materials[0].bump, desc::kNone);
  for (const char* flat : {"Material \"none\"",
                           "MakeNamedMaterial \"a\" \"string type\" \"matte\" "
                           "Material \"mix\" \"string namedmaterial1\" \"a\" "
                           "\"string namedmaterial2\" \"a\""}) {
    EXPECT_TRUE(contains(warnings_of(world(std::string(flat) + " \"float bumpmap\" 1")),
                         "unused parameter \"float bumpmap\""))
        << flat;
  }
}

TEST(PbrtSpectra, AllSpellingsAreUnderstood) {
  const auto kd = [](const std::string& parameter) {
    return material_of("Material \"matte\" " + parameter).color("reflectance");
  };
  expect_rgb(kd("\"rgb Kd\" [.1 .2 .3]"), {0.1F, 0.2F, 0.3F});
  expect_rgb(kd("\"color Kd\" [.1 .2 .3]"), {0.1F, 0.2F, 0.3F});
  expect_rgb(kd("\"xyz Kd\" [.95047 1 1.08883]"), desc::Rgb(1.F), 1e-3F);
  expect_rgb(kd("\"blackbody Kd\" [5500 .5]"), desc::Rgb(blackbody_rgb(5500.0) * 0.5));
  const desc::Rgb flat = kd("\"spectrum Kd\" [400 .4 700 .4]");
  EXPECT_NEAR(luminance({flat.x, flat.y, flat.z}), 0.4F, 1e-4F);
  expect_rgb(flat, kd("\"spectrum Kd\" [500 .4]"));
}

TEST(PbrtTextures, HaveTheDefaultsOfPbrt) {
  const desc::Node checks = texture_of("Texture \"t\" \"spectrum\" \"checkerboard\"");
  EXPECT_TRUE(checks.is("checkerboard"));
  EXPECT_EQ(checks.color("first"), desc::Rgb(1.F));
  EXPECT_EQ(checks.color("second"), desc::Rgb(0.F));
  const desc::Node marble = texture_of("Texture \"t\" \"color\" \"marble\"");
  EXPECT_EQ(marble.integer("octaves"), 8);
  EXPECT_EQ(marble.number("roughness"), 0.5F);
  EXPECT_EQ(marble.number("variation"), 0.2F);
  const desc::Node bilinear = texture_of("Texture \"t\" \"float\" \"bilerp\" \"float v10\" 7");
  EXPECT_TRUE(bilinear.is("bilinear"));
  EXPECT_EQ(bilinear.color("v10"), desc::Rgb(7.F));
  EXPECT_EQ(bilinear.color("v01"), desc::Rgb(1.F));
  const desc::Node mix = texture_of("Texture \"t\" \"float\" \"mix\"");
  EXPECT_EQ(mix.color("first"), desc::Rgb(0.F));
  EXPECT_EQ(mix.number("amount"), 0.5F);
  const desc::Node product =
      texture_of("Texture \"t\" \"spectrum\" \"scale\" \"rgb tex1\" [.1 .2 .3]");
  EXPECT_TRUE(product.is("product"));
  EXPECT_EQ(product.color("first"), desc::Rgb(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(product.color("second"), desc::Rgb(1.F));
  EXPECT_EQ(texture_of("Texture \"t\" \"float\" \"constant\"").color("value"), desc::Rgb(1.F));
}

TEST(PbrtTextures, PtexIsGrayWithAWarning) {
  const std::string body =
      "Texture \"t\" \"color\" \"ptex\" \"string filename\" \"a.ptx\" Material \"matte\" \"texture "
      "Kd\" \"t\"";
  EXPECT_TRUE(
      contains(warnings_of(world(body)), "ptex textures are not supported: grey stands in"));
  Warnings warnings;
  const desc::SceneDesc scene = import_with(world(body), warnings);
  EXPECT_EQ(scene.textures.at(0).node.get("value"), desc::Value(Vec3(0.5F)));
}

TEST(PbrtTextures, OfOtherTypesAndValuesAreErrors) {
  EXPECT_TRUE(contains(error_of(world("Texture \"t\" \"float\" \"marbel\"")),
                       "2:1: unknown texture \"marbel\"; did you mean \"marble\"?"));
  EXPECT_TRUE(contains(error_of(world("Texture \"t\" \"float\" \"fbm\" \"integer octaves\" 65")),
                       "2:1: \"octaves\" must be between 0 and 64, not 65"));
  EXPECT_TRUE(
      contains(error_of(world("Texture \"t\" \"float\" \"checkerboard\" \"integer dimension\" 4")),
               "a checkerboard has dimension 2 or 3, not 4"));
  EXPECT_TRUE(
      contains(error_of(world("Texture \"t\" \"float\" \"uv\" \"string mapping\" \"spheric\"")),
               "unknown value of \"mapping\" \"spheric\"; did you mean \"spherical\"?"));
}

TEST(PbrtTextures, ParametersOfOtherMappingsAreUnused) {
  for (const auto& [mapping, parameter] :
       {std::pair("uv", "vector v1"), std::pair("planar", "float uscale"),
        std::pair("spherical", "float udelta")}) {
    const bool is_vector = std::string(parameter).starts_with("vector");
    const std::string text = "Texture \"t\" \"float\" \"uv\" \"string mapping\" \"" +
                             std::string(mapping) + "\" \"" + parameter + "\" " +
                             (is_vector ? "[1 2 3]" : "2");
    EXPECT_TRUE(contains(warnings_of(world(text)), "unused parameter")) << text;
  }
}

TEST(PbrtTextures, ImagesAreResolvedAndDecoded) {
  const desc::SceneDesc s = scene_of(
      "Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"a/../b.png\" \"string wrap\" "
      "\"clamp\" \"bool gamma\" \"false\" "
      "\"float uscale\" 3 \"float scale\" 2 \"bool trilinear\" true \"float maxanisotropy\" 4",
      {{"b.png", ""}});
  const desc::Node& image = named_texture(s);
  EXPECT_EQ(image.text("file"), "b.png");
  EXPECT_EQ(image.text("wrap"), "clamp");
  EXPECT_FALSE(image.flag("decode_srgb"));
  EXPECT_EQ(image.number("scale"), 2.F);
  EXPECT_EQ(image.number("scale_u"), 3.F);
  const desc::Node colour =
      texture_of("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"x.png\"");
  EXPECT_TRUE(colour.flag("decode_srgb"));
  EXPECT_EQ(colour.text("file").front(), '/');
  EXPECT_TRUE(contains(warnings_of(world("Texture \"t\" \"spectrum\" \"imagemap\"")),
                       "this image texture has no \"string filename\""));
}

TEST(PbrtTextures, MappingsUseTheCurrentTransform) {
  const desc::Node sphere = texture_of(
      "Translate 1 0 0 Texture \"t\" \"spectrum\" \"uv\" \"string mapping\" \"spherical\"");
  EXPECT_EQ(sphere.transform("world_to_texture")[3][0], -1.0);
  const desc::Node plane = texture_of(
      "Texture \"t\" \"spectrum\" \"uv\" \"string mapping\" \"planar\" \"vector v1\" [1 2 3] "
      "\"float vdelta\" 4");
  EXPECT_EQ(plane.vector("axis_u"), Vec3(1.F, 2.F, 3.F));
  EXPECT_EQ(plane.number("offset_v"), 4.F);
  // pbrt-v3 applies the transform itself to points of solid textures.
  for (const char* solid : {"\"fbm\"", "\"checkerboard\" \"integer dimension\" 3"}) {
    const desc::Node node = texture_of("Scale 2 2 2 Texture \"t\" \"float\" " + std::string(solid));
    EXPECT_EQ(node.transform("world_to_texture")[0][0], 2.0) << solid;
  }
}

TEST(PbrtTextures, FloatAndSpectrumOnesAreDifferentEvenOfOneName) {
  const desc::SceneDesc s = scene_of(
      "Texture \"t\" \"float\" \"constant\" \"float value\" .25 Texture \"t\" \"spectrum\" "
      "\"constant\" \"rgb value\" [1 0 0] "
      "Material \"matte\" \"texture Kd\" \"t\" \"texture sigma\" \"t\"");
  const desc::Node& m = s.materials[0].node;
  expect_rgb(constant(s, m.texture("reflectance")), {1.F, 0.F, 0.F});
  expect_rgb(constant(s, m.texture("sigma")), desc::Rgb(0.25F));
  EXPECT_TRUE(contains(
      warnings_of(
          world("Texture \"f\" \"float\" \"constant\" Material \"matte\" \"texture Kd\" \"f\"")),
      "needs a spectrum texture"));
  EXPECT_TRUE(contains(warnings_of(world("Material \"matte\" \"texture Kd\" \"none\"")),
                       "2:18: unknown spectrum texture \"none\""));
}

TEST(PbrtTextures, EndWithTheirScope) {
  const std::string inner =
      "AttributeBegin Texture \"t\" \"float\" \"constant\" AttributeEnd Material \"matte\" "
      "\"texture sigma\" \"t\"";
  EXPECT_TRUE(contains(warnings_of(world(inner)), "unknown float texture"));
  const desc::SceneDesc s =
      scene_of("Texture \"t\" \"float\" \"constant\" \"float value\" 3 " + inner);
  expect_rgb(constant(s, s.materials[0].node.texture("sigma")), desc::Rgb(3.F));
}

}  // namespace
}  // namespace ajar
