// Materials and textures of pbrt-v4: defaults, names, meanings.
#include "import/pbrt/v4_test_support.h"
#include "scene/desc/models.h"

namespace ajar {
namespace {

TEST(Pbrt4Materials, HaveTheDefaultsOfPbrt) {
  EXPECT_EQ(v4_material(""), desc::material_node("diffuse"));
  EXPECT_EQ(v4_material("Material \"diffuse\""), desc::material_node("diffuse"));
  {
    const desc::Node m = v4_material("Material \"coateddiffuse\"");
    EXPECT_TRUE(m.is("coated_diffuse"));
    EXPECT_EQ(m.text("coat"), "dielectric");
    EXPECT_EQ(m.number("eta"), 1.5F);
    EXPECT_EQ(m.number("roughness"), 0.F);
    EXPECT_EQ(m.number("roughness_v"), 0.F);
    EXPECT_EQ(m.text("roughness_scale"), "square");
    EXPECT_EQ(m.get("coat_depth"), desc::Value(Vec3(0.01F)));
    EXPECT_EQ(m.integer("bounces"), 5);
    EXPECT_EQ(m.text("coat_transmission"), "lossy");
    EXPECT_EQ(v4_material("Material \"coateddiffuse\" \"integer maxdepth\" 2 \"float thickness\" 1")
                  .integer("bounces"),
              1);
  }
  {
    const desc::Node m = v4_material("Material \"coatedconductor\"");
    EXPECT_EQ(m.get("coat_depth"), desc::Value(Vec3(0.01F)));
    EXPECT_TRUE(m.is("coated_conductor"));
    EXPECT_EQ(m.number("coat_eta"), 1.5F);
    EXPECT_EQ(m.number("coat_roughness"), 0.F);
    EXPECT_EQ(m.number("roughness"), 0.F);
    EXPECT_EQ(m.text("coat_transmission"), "lossy");
    EXPECT_EQ(m.integer("bounces"), 5);
  }
  {
    const desc::Node m = v4_material("Material \"diffusetransmission\" \"float scale\" .5");
    EXPECT_TRUE(m.is("translucent"));
    EXPECT_EQ(m.color("diffuse"), desc::Rgb(0.5F));
    EXPECT_EQ(m.color("glossy"), desc::Rgb(0.F));
    EXPECT_EQ(m.color("reflectance"), desc::Rgb(0.25F));
    EXPECT_EQ(m.color("transmittance"), desc::Rgb(0.25F));
  }
  EXPECT_TRUE(v4_material("Material \"thindielectric\"").flag("thin"));
  EXPECT_FALSE(v4_material("Material \"dielectric\"").flag("thin"));
  EXPECT_TRUE(v4_material("Material \"interface\"").is("interface"));
}

TEST(Pbrt4Materials, RoughnessIsTheSquareOfAlpha) {
  const desc::Node m = v4_material("Material \"dielectric\" \"float roughness\" .25");
  EXPECT_EQ(m.number("roughness"), 0.25F);
  EXPECT_EQ(m.text("roughness_scale"), "square");
  EXPECT_EQ(
      v4_material("Material \"dielectric\" \"bool remaproughness\" false").text("roughness_scale"),
      "alpha");
  const desc::Node uneven =
      v4_material("Material \"conductor\" \"float roughness\" .25 \"float vroughness\" .5");
  EXPECT_EQ(uneven.number("roughness"), 0.25F);
  EXPECT_EQ(uneven.number("roughness_v"), 0.5F);
}

TEST(Pbrt4Materials, MetalsWithHardlyAnyRoughnessAreSmooth) {
  const auto distribution = [](const std::string& parameters) {
    return v4_material("Material \"conductor\" " + parameters).text("distribution");
  };
  EXPECT_EQ(distribution(""), "smooth");
  EXPECT_EQ(distribution("\"float roughness\" 5e-7"), "smooth");
  EXPECT_EQ(distribution("\"float roughness\" 5e-6"), "ggx");
  EXPECT_EQ(distribution("\"float roughness\" 5e-4 \"bool remaproughness\" false"), "smooth");
  EXPECT_EQ(distribution("\"float vroughness\" .1"), "ggx");
}

TEST(Pbrt4Materials, MetalsMayBeGivenByTheirReflectance) {
  const desc::Node m = v4_material("Material \"conductor\" \"rgb reflectance\" [.9 .5 .1]");
  EXPECT_EQ(m.color("reflectance"), desc::Rgb(0.9F, 0.5F, 0.1F));
}

TEST(Pbrt4Materials, AmountOfAMixIsThatOfTheSecond) {
  const desc::SceneDesc s = v4_scene(
      "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" "
      "MakeNamedMaterial \"b\" \"string type\" \"interface\" "
      "Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" .25");
  const desc::Node& mix = material_node_of(s, s.shapes.back());
  EXPECT_EQ(mix.color("amount"), desc::Rgb(0.25F));
  // A mere boundary between media lets nothing pass in a mix.
  const desc::Node& clear = s.materials[static_cast<std::size_t>(mix.material("first"))].node;
  ASSERT_TRUE(clear.is("composite"));
  EXPECT_EQ(clear.color("opacity"), desc::Rgb(0.F));
  EXPECT_EQ(s.materials[static_cast<std::size_t>(mix.material("second"))].name, "a");
  EXPECT_TRUE(contains(error_of(v4_world("Material \"mix\"")), "needs \"string materials\""));
}

TEST(Pbrt4Materials, NamesOutliveTheirBlock) {
  const desc::SceneDesc s = v4_scene(
      "AttributeBegin MakeNamedMaterial \"a\" \"string type\" \"dielectric\" AttributeEnd "
      "NamedMaterial \"a\"");
  EXPECT_TRUE(material_node_of(s, s.shapes.back()).is("dielectric"));
}

TEST(Pbrt4Materials, UnsupportedOnesHaveSimilarReplacements) {
  EXPECT_TRUE(contains(v4_warnings("Material \"hair\""),
                       "test.pbrt:2:1: material \"hair\" is not supported: a matte one stands in"));
  const auto stand_in = [](const std::string& body) {
    const desc::SceneDesc s = v4_scene_with_warnings(body);
    return material_node_of(s, s.shapes.back());
  };
  // Brown: more red than blue.
  const desc::Rgb hair = stand_in("Material \"hair\"").color("reflectance");
  EXPECT_GT(hair.x, 1.5F * hair.z);
  EXPECT_EQ(stand_in("Material \"hair\" \"rgb color\" [.1 .2 .3]").color("reflectance"),
            desc::Rgb(0.1F, 0.2F, 0.3F));
  const desc::Node milk = stand_in("Material \"subsurface\" \"string name\" \"Wholemilk\"");
  EXPECT_TRUE(milk.is("coated_diffuse"));
  EXPECT_EQ(milk.number("eta"), 1.33F);
  EXPECT_GT(milk.color("diffuse_reflectance").x, 0.9F);
  EXPECT_LT(milk.color("diffuse_reflectance").z, milk.color("diffuse_reflectance").x);
  const desc::Node ketchup = stand_in("Material \"subsurface\" \"string name\" \"Ketchup\"");
  EXPECT_GT(ketchup.color("diffuse_reflectance").x, 5.F * ketchup.color("diffuse_reflectance").z);
  EXPECT_TRUE(contains(v4_warnings("Material \"measured\" \"string filename\" \"a.bsdf\""),
                       "material \"measured\" is not supported"));
}

TEST(Pbrt4Materials, HairHasTheColorThatItReflects) {
  const auto hair = [](const std::string& parameters) {
    const desc::SceneDesc s = v4_scene_with_warnings("Material \"hair\" " + parameters);
    return material_node_of(s, s.shapes.back()).color("reflectance");
  };
  const desc::Rgb red(0.9F, 0.1F, 0.1F);
  EXPECT_EQ(hair("\"rgb reflectance\" [.9 .1 .1]"), red);
  EXPECT_EQ(hair("\"rgb reflectance\" [.9 .1 .1] \"float eumelanin\" 8"), red);
  // Absorption comes before it: without any, hair is white.
  expect_rgb(hair("\"rgb reflectance\" [.9 .1 .1] \"rgb sigma_a\" [0 0 0]"), desc::Rgb(1.F));
  EXPECT_TRUE(contains(
      v4_warnings("Material \"hair\" \"rgb reflectance\" [.9 .1 .1] \"rgb sigma_a\" [0 0 0]"),
      "unused parameter \"rgb reflectance\""));
}

TEST(Pbrt4Materials, ReplacementsKeepTheirTextures) {
  for (const char* parameter : {"\"hair\" \"texture sigma_a\"", "\"hair\" \"texture eumelanin\"",
                                "\"hair\" \"texture beta_m\"", "\"subsurface\" \"texture sigma_s\"",
                                "\"subsurface\" \"texture mfp\""}) {
    EXPECT_TRUE(contains(v4_warnings("Material " + std::string(parameter) + " \"nope\""),
                         "texture \"nope\""))
        << parameter;
  }
  const std::string noise = "Texture \"n\" \"float\" \"fbm\" ";
  EXPECT_TRUE(
      contains(v4_warnings(noise + "Material \"hair\" \"texture eumelanin\" \"n\""),
               "\"eumelanin\" is a texture, which the stand-in cannot follow: its default counts"));
  const auto eumelanin = [](const std::string& texture) {
    const desc::SceneDesc s = v4_scene_with_warnings(
        "Texture \"n\" \"float\" \"constant\" \"float value\" 0 Material \"hair\" " + texture);
    return material_node_of(s, s.shapes.back()).color("reflectance");
  };
  expect_rgb(eumelanin("\"texture eumelanin\" \"n\""), desc::Rgb(1.F));
}

TEST(Pbrt4Materials, SubsurfaceUsesOneOfThreeParameterSets) {
  const auto color = [](const std::string& parameters) {
    const desc::SceneDesc s = v4_scene_with_warnings("Material \"subsurface\" " + parameters);
    return material_node_of(s, s.shapes.back()).color("diffuse_reflectance");
  };
  const std::string reflectance = "\"rgb reflectance\" [.1 .2 .3] ";
  EXPECT_EQ(color(reflectance), desc::Rgb(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(color(reflectance + "\"string name\" \"Ketchup\""),
            color("\"string name\" \"Ketchup\""));
  EXPECT_EQ(color(reflectance + "\"rgb sigma_s\" [0 0 0] \"rgb sigma_a\" [1 1 1]"), desc::Rgb(0.F));
  // Forward scattering counts for coefficients and not for presets, whose scattering is reduced.
  const std::string forward = "\"float g\" .9 ";
  const std::string coefficients = "\"rgb sigma_s\" [1 1 1] \"rgb sigma_a\" [1 1 1] ";
  EXPECT_LT(color(coefficients + forward).x, 0.5F * color(coefficients).x);
  EXPECT_EQ(color("\"string name\" \"Ketchup\" " + forward), color("\"string name\" \"Ketchup\""));
  EXPECT_TRUE(contains(v4_warnings("Material \"subsurface\" \"string name\" \"Ketchap\""),
                       "unknown medium preset \"Ketchap\"; did you mean \"Ketchup\"?"));
  EXPECT_TRUE(contains(v4_warnings("Material \"subsurface\" \"rgb Kt\" [1 0 0]"),
                       "unused parameter \"rgb Kt\""));
}

TEST(Pbrt4Materials, MetalsHaveAnIndexOrAReflectance) {
  const std::string both = "\"rgb reflectance\" [.5 .5 .5] ";
  EXPECT_TRUE(contains(v4_warnings("Material \"conductor\" \"rgb k\" [1 1 1] " + both),
                       "2:1: pbrt-v4 refuses \"eta\" and \"k\" beside \"reflectance\""));
  EXPECT_TRUE(
      contains(v4_warnings("Material \"coatedconductor\" \"rgb conductor.eta\" [1 1 1] " + both),
               "here the reflectance counts"));
  EXPECT_EQ(v4_warnings("Material \"conductor\" " + both), "");
}

TEST(Pbrt4Materials, CoatedMetalsKeepTheirMaximumDepth) {
  const std::string metal = "Material \"coatedconductor\" \"integer maxdepth\" ";
  EXPECT_EQ(v4_warnings(metal + "2"), "");
  EXPECT_EQ(v4_material(metal + "2").integer("bounces"), 1);
}

TEST(Pbrt4Materials, UnsupportedOptionsHaveLocatedWarnings) {
  EXPECT_TRUE(contains(v4_warnings("Material \"difuse\""),
                       "test.pbrt:2:1: unknown material \"difuse\"; did you mean \"diffuse\"?"));
  EXPECT_TRUE(
      contains(v4_warnings("Material \"coateddiffuse\" \"rgb albedo\" [.5 .5 .5]"), "\"albedo\""));
  EXPECT_TRUE(contains(v4_warnings("Material \"diffuse\" \"float rougness\" 1"),
                       "unused parameter \"float rougness\""));
}

TEST(Pbrt4Materials, NormalMapsAreFilesOfVectors) {
  const desc::SceneDesc s =
      v4_scene("Material \"diffuse\" \"string normalmap\" \"n.png\"", {{"n.png", ""}});
  const desc::NormalMap& map =
      s.materials[static_cast<std::size_t>(s.shapes.back().material)].normal_map;
  ASSERT_EQ(map.texture, 0);
  EXPECT_TRUE(map.right_handed);
  EXPECT_EQ(s.textures[0].node.text("file"), "n.png");
  EXPECT_FALSE(s.textures[0].node.flag("decode_srgb"));
}

TEST(Pbrt4Materials, ImagesOfIndicesMayBeAboveOne) {
  const desc::SceneDesc s = v4_scene(
      "Texture \"k\" \"spectrum\" \"imagemap\" \"string filename\" \"k.exr\" Material "
      "\"conductor\" \"texture k\" \"k\"",
      {{"k.exr", ""}});
  const desc::TextureId k = material_node_of(s, s.shapes.back()).texture("k");
  EXPECT_FALSE(s.textures.at(static_cast<std::size_t>(k)).node.flag("clamp"));
}

TEST(Pbrt4Materials, NormalMapsComeBeforeBumps) {
  const desc::SceneDesc s = v4_scene(
      "Texture \"t\" \"float\" \"fbm\" Material \"diffuse\" \"texture displacement\" "
      "\"t\" \"string normalmap\" \"n.png\"",
      {{"n.png", ""}});
  const desc::Material& both = s.materials[static_cast<std::size_t>(s.shapes.back().material)];
  EXPECT_EQ(both.bump, desc::kNone);
  EXPECT_NE(both.normal_map.texture, desc::kNone);
}

TEST(Pbrt4Materials, MixesOfPartsWithOtherReliefsAreAWarning) {
  const auto warnings = [](const std::string& second) {
    return v4_warnings(
        "Texture \"t\" \"float\" \"fbm\" MakeNamedMaterial \"bumpy\" \"string type\" \"diffuse\" "
        "\"texture displacement\" \"t\" MakeNamedMaterial \"plain\" \"string type\" \"diffuse\"\n"
        "Material \"mix\" \"string materials\" [\"bumpy\" \"" +
        second + "\"]");
  };
  EXPECT_TRUE(contains(warnings("plain"),
                       "test.pbrt:3:1: the parts of this mix differ in their bump or normal map: "
                       "that of \"plain\" counts for both"));
  EXPECT_EQ(warnings("bumpy"), "");
  // One file is one relief.
  const std::string map = "\"string type\" \"diffuse\" \"string normalmap\" \"n.png\" ";
  EXPECT_EQ(v4_warnings("MakeNamedMaterial \"a\" " + map + "MakeNamedMaterial \"b\" " + map +
                            "Material \"mix\" \"string materials\" [\"a\" \"b\"]",
                        {{"n.png", ""}}),
            "");
}

TEST(Pbrt4Materials, DisplacementIsABump) {
  const desc::SceneDesc s = v4_scene(
      "Texture \"t\" \"float\" \"fbm\" Material \"diffuse\" \"texture displacement\" \"t\"");
  EXPECT_EQ(s.materials[static_cast<std::size_t>(s.shapes.back().material)].bump, 0);
}

desc::Node image(const std::string& parameters, const std::string& kind = "spectrum") {
  return named_texture(v4_scene(
      "Texture \"t\" \"" + kind + "\" \"imagemap\" \"string filename\" \"a.png\" " + parameters,
      {{"a.png", ""}}));
}

TEST(Pbrt4Textures, ColorsOfImagesAreAtMostOne) {
  EXPECT_TRUE(image("\"float scale\" 2").flag("clamp"));
  EXPECT_FALSE(image("").flag("clamp"));  // has none above
  EXPECT_FALSE(image("\"float scale\" 2", "float").flag("clamp"));
  EXPECT_TRUE(named_texture(v4_scene("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" "
                                     "\"a.exr\"",
                                     {{"a.exr", ""}}))
                  .flag("clamp"));
}

TEST(Pbrt4Textures, CylindersMeasureAlongTheirAxis) {
  EXPECT_EQ(named_texture(v4_scene("Texture \"t\" \"spectrum\" \"uv\" \"string mapping\" "
                                   "\"cylindrical\""))
                .text("height"),
            "place");
}

TEST(Pbrt4Textures, ImagesOfOtherFormatsThanItsOwnAreSrgb) {
  const auto jpeg = [](const std::string& kind) {
    return named_texture(v4_scene("Texture \"t\" \"" + kind +
                                      "\" \"imagemap\" \"string filename\" \"a.JPG\" \"string "
                                      "encoding\" \"linear\"",
                                  {{"a.JPG", ""}}));
  };
  EXPECT_TRUE(jpeg("spectrum").flag("decode_srgb"));
  EXPECT_EQ(jpeg("float").text("channel"), "mean");
}

TEST(Pbrt4Textures, ImagesHaveEncodings) {
  EXPECT_TRUE(image("").flag("decode_srgb"));
  EXPECT_FALSE(image("\"string encoding\" \"linear\"").flag("decode_srgb"));
  EXPECT_EQ(image("\"string encoding\" \"gamma 2.2\"").number("decoding_exponent"), 2.2F);
  EXPECT_FALSE(image("").flag("invert"));
  EXPECT_TRUE(image("\"bool invert\" true").flag("invert"));
  EXPECT_EQ(image("\"float scale\" 3").number("scale"), 3.F);
  EXPECT_EQ(image("\"string filter\" \"point\"").text("filter"), "nearest");
  EXPECT_EQ(image("\"string filter\" \"ewa\"").text("filter"), "bilinear");
  EXPECT_TRUE(contains(v4_warnings("Texture \"t\" \"float\" \"imagemap\" \"string filename\" "
                                   "\"a.png\" \"string encoding\" \"gamma\"",
                                   {{"a.png", ""}}),
                       "test.pbrt:2:1: unknown encoding \"gamma\""));
}

TEST(Pbrt4Textures, ImagesOfNumbersAreAlphaOrTheMean) {
  EXPECT_EQ(image("").text("channel"), "color");
  EXPECT_EQ(image("", "float").text("channel"), "varying_alpha_or_mean");
  EXPECT_EQ(image("\"string filter\" \"trilinear\"", "float").text("channel"),
            "varying_alpha_or_mean");
  EXPECT_EQ(image("\"string filter\" \"point\"", "float").text("channel"), "red");
  EXPECT_EQ(image("\"string channel\" \"green\"", "float").text("channel"), "green");
}

TEST(Pbrt4Textures, ScaleIsAProductWithANumber) {
  const desc::SceneDesc s = v4_scene(
      "Texture \"a\" \"spectrum\" \"constant\" \"rgb value\" [1 2 3] "
      "Texture \"t\" \"spectrum\" \"scale\" \"texture tex\" \"a\" \"float scale\" .5");
  const desc::Node& t = named_texture(s);
  EXPECT_TRUE(t.is("product"));
  EXPECT_EQ(t.texture("first"), 0);
  EXPECT_EQ(t.color("second"), desc::Rgb(0.5F));
}

TEST(Pbrt4Textures, SolidOnesMoveWithTheTransform) {
  const desc::Node t = named_texture(v4_scene("Translate 1 2 3 Texture \"t\" \"float\" \"fbm\""));
  EXPECT_EQ(transform_point(t.transform("world_to_texture"), {1.F, 2.F, 3.F}), Vec3(0.F));
  const desc::Node plane =
      named_texture(v4_scene("Translate 2 0 0 Scale 2 1 1 Texture \"t\" \"float\" \"checkerboard\" "
                             "\"string mapping\" \"planar\" \"vector3 v1\" [1 0 0]"));
  // x in the texture's space is (x − 2) / 2.
  EXPECT_NEAR(plane.vector("axis_u").x, 0.5F, 1e-6F);
  EXPECT_NEAR(plane.number("offset_u"), -1.F, 1e-6F);
}

TEST(Pbrt4Textures, UnknownOnesAreGrey) {
  EXPECT_TRUE(contains(v4_warnings("Texture \"t\" \"spectrum\" \"plaid\""),
                       "test.pbrt:2:1: unknown texture \"plaid\""));
  EXPECT_TRUE(contains(v4_warnings("Texture \"t\" \"spectrum\" \"ptex\" \"string filename\" \"a\""),
                       "ptex textures are not supported"));
}

}  // namespace
}  // namespace ajar
