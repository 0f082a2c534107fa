#include "core/spectrum.h"
#include "import/common/conductors.h"
#include "import/mitsuba/import_test_support.h"

namespace ajar::mitsuba {
namespace {

TEST(MitsubaMaterials, DielectricsHaveTheIndexOfTheInsideRelativeToTheOutside) {
  EXPECT_FLOAT_EQ(MaterialOf("<bsdf type=\"dielectric\"/>").node().number("eta"),
                  1.5046F / 1.000277F);
  const MaterialOf water(
      "<bsdf type=\"dielectric\"><string name=\"intIOR\" value=\"Water\"/><float name=\"ext_ior\" "
      "value=\"1\"/></bsdf>");
  EXPECT_FLOAT_EQ(water.node().number("eta"), 1.333F);
  EXPECT_TRUE(MaterialOf("<bsdf type=\"thindielectric\"/>").node().flag("thin"));
  const MaterialOf unknown(
      "<bsdf type=\"dielectric\"><string name=\"int_ior\" value=\"watr\"/></bsdf>");
  EXPECT_TRUE(contains(unknown.warnings, "did you mean \"water\"?")) << unknown.warnings;
}

TEST(MitsubaMaterials, ConductorsKnowMetalsByName) {
  const auto metal = [](const std::string& name) {
    return MaterialOf("<bsdf type=\"roughconductor\"><string name=\"material\" value=\"" + name +
                      "\"/><float name=\"ext_eta\" value=\"1\"/></bsdf>");
  };
  expect_near(metal("Au").node().color("eta"), conductor_named("Au")->eta);
  expect_near(metal("VN").node().color("k"), {3.0323F, 2.0561F, 1.6163F});
  expect_near(metal("V_palik").node().color("eta"), {4.2775F, 3.5132F, 2.7611F});
  const MaterialOf unknown = metal("Aug");
  EXPECT_TRUE(contains(unknown.warnings, "unknown conductor \"Aug\"")) << unknown.warnings;
  expect_near(unknown.node().color("eta"), conductor_named("Cu")->eta);
}

TEST(MitsubaMaterials, ConductorsWithoutAMetalAreIdealMirrorsAndCopperBeforeVersion2) {
  EXPECT_TRUE(MaterialOf("<bsdf type=\"conductor\"/>").node().is("mirror"));
  const MaterialOf rough("<bsdf type=\"roughconductor\"/>");
  EXPECT_EQ(rough.node().color("eta"), Vec3(0.F));
  EXPECT_NEAR(rough.node().color("k").x, 1.F, 1e-3F);
  const MaterialOf half("<bsdf type=\"conductor\"><rgb name=\"eta\" value=\"2\"/></bsdf>");
  EXPECT_NEAR(half.node().color("eta").x, 2.F, 1e-3F);
  EXPECT_NEAR(half.node().color("k").x, 1.F, 1e-3F);
  Warnings warnings;
  std::string text = world(sphere_of("<bsdf type=\"conductor\"/>"));
  text.replace(text.find("3.0.0"), 5, "0.6.0");
  const desc::SceneDesc old = import_with(text, warnings, {});
  expect_near(old.materials[static_cast<std::size_t>(old.shapes.front().material)].node.color("k") *
                  1.000277F,
              conductor_named("Cu")->k);
}

TEST(MitsubaMaterials, ConductorsAreRelativeToTheOutside) {
  const MaterialOf in_water(
      "<bsdf type=\"roughconductor\"><rgb name=\"eta\" value=\"2\"/><rgb name=\"k\" "
      "value=\"4\"/><float name=\"extEta\" value=\"1.25\"/></bsdf>");
  expect_near(in_water.node().color("eta"), Vec3(1.6F));
  expect_near(in_water.node().color("k"), Vec3(3.2F));
}

TEST(MitsubaMaterials, TintedConductorsAreMixesWithBlack) {
  const MaterialOf tinted(
      "<bsdf type=\"roughconductor\"><string name=\"distribution\" value=\"beckmann\"/><float "
      "name=\"alpha\" value=\"0.2\"/><rgb name=\"specularReflectance\" value=\"0.3\"/></bsdf>");
  ASSERT_TRUE(tinted.node().is("mix"));
  EXPECT_EQ(tinted.node().color("amount"), Vec3(0.3F));
  const desc::Node& metal = tinted.material(tinted.node().material("first")).node;
  EXPECT_EQ(metal.text("distribution"), "beckmann");
  EXPECT_EQ(metal.text("masking"), "separable");
  const MaterialOf glass("<bsdf type=\"roughdielectric\"/>");
  EXPECT_EQ(glass.node().text("distribution"), "beckmann");
  EXPECT_EQ(glass.node().text("masking"), "separable");
  EXPECT_EQ(glass.warnings, "");
  EXPECT_EQ(metal.number("roughness"), 0.2F);
  const desc::Node& black = tinted.material(tinted.node().material("second")).node;
  EXPECT_EQ(black.color("reflectance"), Vec3(0.F));
}

TEST(MitsubaMaterials, PlasticIsACoatedBase) {
  const MaterialOf plastic(
      "<bsdf type=\"roughplastic\"><string name=\"distribution\" value=\"ggx\"/><float "
      "name=\"alpha\" value=\"0.3\"/><rgb name=\"diffuse_reflectance\" value=\"0.8\"/><rgb "
      "name=\"specular_reflectance\" value=\"0.5\"/></bsdf>");
  EXPECT_EQ(plastic.warnings, "");
  ASSERT_TRUE(plastic.node().is("coated_diffuse"));
  EXPECT_EQ(plastic.node().text("coat"), "dielectric");
  EXPECT_FLOAT_EQ(plastic.node().number("eta"), 1.49F / 1.000277F);
  EXPECT_EQ(plastic.node().color("diffuse_reflectance"), Vec3(0.8F));
  EXPECT_EQ(plastic.node().color("coat_reflectance"), Vec3(0.5F));
  EXPECT_EQ(plastic.node().number("roughness"), 0.3F);
  EXPECT_EQ(plastic.node().text("inner_reflections"), "white");
  EXPECT_EQ(plastic.node().text("masking"), "separable");
  EXPECT_EQ(plastic.node().text("coat_transmission"), "lossy_sum");
  const MaterialOf smooth("<bsdf type=\"plastic\"/>");
  EXPECT_EQ(smooth.warnings, "");
  EXPECT_EQ(smooth.node().number("roughness"), 0.F);
  const MaterialOf nonlinear(
      "<bsdf type=\"plastic\"><boolean name=\"nonlinear\" value=\"true\"/></bsdf>");
  EXPECT_EQ(nonlinear.node().text("inner_reflections"), "base");
  const MaterialOf usual("<bsdf type=\"roughplastic\"/>");
  EXPECT_EQ(usual.node().text("distribution"), "beckmann");
  EXPECT_EQ(usual.warnings, "");
}

TEST(MitsubaMaterials, RoughPlasticLosesNothingInsideBeforeVersion2) {
  Warnings warnings;
  std::string text = world(sphere_of("<bsdf type=\"roughplastic\"/>"));
  text.replace(text.find("3.0.0"), 5, "0.6.0");
  const desc::SceneDesc old = import_with(text, warnings);
  const auto material = static_cast<std::size_t>(old.shapes.front().material);
  EXPECT_EQ(old.materials[material].node.text("coat_transmission"), "single");
}

TEST(MitsubaMaterials, PolarizedPlasticIsABaseBehindTwoWindows) {
  const MaterialOf plastic("<bsdf type=\"pplastic\"><float name=\"alpha\" value=\"0.2\"/></bsdf>");
  EXPECT_EQ(plastic.warnings, "");
  ASSERT_TRUE(plastic.node().is("coated_diffuse"));
  EXPECT_EQ(plastic.node().number("roughness"), 0.2F);
  EXPECT_EQ(plastic.node().text("distribution"), "beckmann");
  EXPECT_EQ(plastic.node().text("coat_transmission"), "smooth");
  EXPECT_EQ(plastic.node().text("inner_reflections"), "windows");
}

TEST(MitsubaMaterials, CoatsAreLayers) {
  const MaterialOf wood(
      "<bsdf type=\"coating\"><float name=\"int_ior\" value=\"1.5\"/><float name=\"ext_ior\" "
      "value=\"1\"/><bsdf type=\"diffuse\"/></bsdf>");
  ASSERT_TRUE(wood.node().is("coated_diffuse"));
  EXPECT_EQ(wood.node().integer("bounces"), 1);
  EXPECT_EQ(wood.node().get("coat_depth"), desc::Value(Vec3(0.F)));
  EXPECT_EQ(wood.node().number("roughness"), 0.F);
  const MaterialOf lacquer(
      "<bsdf type=\"roughcoating\"><float name=\"int_ior\" value=\"1.5\"/><float name=\"ext_ior\" "
      "value=\"1\"/><float name=\"alpha\" value=\"0.2\"/><string name=\"distribution\" "
      "value=\"ggx\"/><bsdf type=\"roughconductor\"><rgb name=\"eta\" value=\"2\"/><rgb name=\"k\" "
      "value=\"4\"/><float name=\"ext_eta\" value=\"1\"/><float name=\"alpha\" "
      "value=\"0.1\"/></bsdf></bsdf>");
  ASSERT_TRUE(lacquer.node().is("coated_conductor"));
  expect_near(lacquer.node().color("eta"), Vec3(3.F));
  expect_near(lacquer.node().color("k"), Vec3(6.F));
  EXPECT_EQ(lacquer.node().number("coat_eta"), 1.5F);
  EXPECT_EQ(lacquer.node().number("coat_roughness"), 0.2F);
  EXPECT_EQ(lacquer.node().number("roughness"), 0.1F);
  EXPECT_EQ(lacquer.node().text("distribution"), "beckmann");
  EXPECT_EQ(lacquer.node().text("coat_distribution"), "ggx");
  EXPECT_EQ(lacquer.node().text("coat_transmission"), "single");
  EXPECT_EQ(lacquer.node().integer("bounces"), 1);
  EXPECT_EQ(lacquer.warnings, "");
  const MaterialOf glass("<bsdf type=\"coating\"><bsdf type=\"dielectric\"/></bsdf>");
  EXPECT_TRUE(glass.node().is("dielectric"));
  EXPECT_TRUE(contains(glass.warnings, "left out"));
}

TEST(MitsubaMaterials, BlendsWeighTheSecond) {
  const MaterialOf blend(
      "<bsdf type=\"blendbsdf\"><float name=\"weight\" value=\"0.25\"/><bsdf type=\"dielectric\"/>"
      "<bsdf type=\"null\"/></bsdf>");
  EXPECT_EQ(blend.node().color("amount"), Vec3(0.25F));
  EXPECT_TRUE(blend.material(blend.node().material("second")).node.is("dielectric"));
  // Nothing lets light pass, which a mere boundary between media in a mix does not.
  const desc::Node& nothing = blend.material(blend.node().material("first")).node;
  ASSERT_TRUE(nothing.is("composite"));
  EXPECT_EQ(nothing.color("opacity"), Vec3(0.F));
}

TEST(MitsubaMaterials, ColoursAreNumbersByLuminanceAndBeforeVersion2ByTheirMean) {
  const std::string image =
      "<texture type=\"bitmap\" name=\"weight\"><string name=\"filename\" "
      "value=\"a.png\"/></texture>";
  const auto blend = [](const std::string& weight) {
    return "<bsdf type=\"blendbsdf\">" + weight +
           "<bsdf type=\"dielectric\"/><bsdf type=\"null\"/></bsdf>";
  };
  const auto channel = [](const desc::SceneDesc& scene) {
    return scene.textures.front().node.text("channel");
  };
  EXPECT_EQ(channel(MaterialOf(blend(image)).scene), "luminance");
  EXPECT_NEAR(MaterialOf(blend("<rgb name=\"weight\" value=\"1 0 0\"/>")).node().color("amount").y,
              luminance(Spectrum(1.F, 0.F, 0.F)), 1e-6F);
  Warnings warnings;
  std::string text = world(sphere_of(blend(image)));
  text.replace(text.find("3.0.0"), 5, "0.6.0");
  EXPECT_EQ(channel(import_with(text, warnings, {{"a.png", ""}})), "mean");
}

TEST(MitsubaMaterials, PatternsAreNumbersAsImagesAre) {
  const MaterialOf blend(
      "<bsdf type=\"blendbsdf\"><texture type=\"checkerboard\" name=\"weight\"><rgb "
      "name=\"color0\" "
      "value=\"1 0 0\"/><rgb name=\"color1\" value=\"0 1 0\"/></texture>"
      "<bsdf type=\"dielectric\"/><bsdf type=\"null\"/></bsdf>");
  // Checkerboards of numbers have their colours the other way round since version 2.
  const desc::Node& weight = blend.texture("amount");
  EXPECT_NEAR(weight.color("second").z, luminance(Spectrum(1.F, 0.F, 0.F)), 1e-6F);
  EXPECT_NEAR(weight.color("first").x, luminance(Spectrum(0.F, 1.F, 0.F)), 1e-6F);
}

TEST(MitsubaMaterials, HeightsAreLuminances) {
  const MaterialOf bumpy(
      "<bsdf type=\"bumpmap\"><texture type=\"bitmap\"><string name=\"filename\" value=\"h.png\"/>"
      "</texture><bsdf type=\"diffuse\"/></bsdf>");
  const desc::TextureId height = bumpy.material(bumpy.scene.shapes.front().material).bump;
  EXPECT_EQ(bumpy.scene.textures.at(static_cast<std::size_t>(height)).node.text("channel"),
            "luminance");
}

TEST(MitsubaMaterials, OpacitiesOfColoursAreNumbersSinceVersion2) {
  const std::string mask =
      "<bsdf type=\"mask\"><rgb name=\"opacity\" value=\"1 0 0\"/><bsdf type=\"diffuse\"/></bsdf>";
  EXPECT_NEAR(MaterialOf(mask).node().color("amount").y, luminance(Spectrum(1.F, 0.F, 0.F)), 1e-6F);
  Warnings warnings;
  std::string text = world(sphere_of(mask));
  text.replace(text.find("3.0.0"), 5, "0.6.0");
  const desc::SceneDesc old = import_with(text, warnings, {});
  const auto material = static_cast<std::size_t>(old.shapes.front().material);
  EXPECT_EQ(old.materials[material].node.color("amount"), Vec3(1.F, 0.F, 0.F));
}

TEST(MitsubaMaterials, UnsupportedOptionsOfCoatsAreWarnings) {
  const auto warnings = [](const std::string& bsdf) { return MaterialOf(bsdf).warnings; };
  EXPECT_TRUE(
      contains(warnings("<bsdf type=\"plastic\"><float name=\"int_ior\" value=\"1\"/><float "
                        "name=\"ext_ior\" value=\"1.3\"/></bsdf>"),
               "it has no gloss"));
  EXPECT_TRUE(contains(
      warnings(
          "<bsdf type=\"coating\"><bsdf type=\"bumpmap\"><texture type=\"bitmap\"><string "
          "name=\"filename\" value=\"h.png\"/></texture><bsdf type=\"diffuse\"/></bsdf></bsdf>"),
      "tilts the coat, too"));
  EXPECT_TRUE(contains(
      warnings("<bsdf type=\"coating\"><rgb name=\"specular_reflectance\" value=\"0.5\"/><bsdf "
               "type=\"roughconductor\"><string name=\"material\" value=\"Au\"/></bsdf></bsdf>"),
      "\"specular_reflectance\" of a coat on metal is not supported"));
}

TEST(MitsubaMaterials, MixturesKeepTheirWeights) {
  const MaterialOf mixture(
      "<bsdf type=\"mixturebsdf\"><string name=\"weights\" value=\"0.5, 0.25\"/>"
      "<bsdf type=\"difftrans\"/><bsdf type=\"dielectric\"/></bsdf>");
  ASSERT_TRUE(mixture.node().is("mix"));
  EXPECT_NEAR(mixture.node().color("amount").x, 0.5F, 1e-6F);
  const desc::Node& rest = mixture.material(mixture.node().material("second")).node;
  EXPECT_NEAR(rest.color("amount").x, 0.5F, 1e-6F);  // a quarter of the half that is left
  EXPECT_EQ(mixture.material(rest.material("second")).node.color("reflectance"), Vec3(0.F));
}

TEST(MitsubaMaterials, MasksCutAwayAndMix) {
  const MaterialOf mask(
      "<bsdf type=\"mask\"><texture type=\"bitmap\" name=\"opacity\"><string name=\"filename\" "
      "value=\"leaf.png\"/></texture><bsdf type=\"difftrans\"/></bsdf>");
  ASSERT_TRUE(mask.node().is("mix"));
  EXPECT_EQ(mask.scene.shapes[0].alpha, mask.node().texture("amount"));
  EXPECT_TRUE(mask.material(mask.node().material("first")).node.is("translucent"));
  EXPECT_EQ(mask.scene.textures.at(static_cast<std::size_t>(mask.node().texture("amount")))
                .node.text("channel"),
            "luminance");
}

const std::string kNormalMap =
    "<texture type=\"bitmap\"><string name=\"filename\" value=\"n.png\"/><boolean name=\"raw\" "
    "value=\"true\"/></texture>";

TEST(MitsubaMaterials, NormalMapsMayBeTheSameEverywhere) {
  for (const std::string map :
       {"<rgb name=\"normalmap\" value=\"0.9 0.5 0.8\"/>",
        "<texture name=\"normalmap\" type=\"srgb\"><rgb name=\"color\" value=\"0.9 0.5 "
        "0.8\"/></texture>"}) {
    const MaterialOf tilted("<bsdf type=\"normalmap\">" + map + "<bsdf type=\"diffuse\"/></bsdf>");
    EXPECT_EQ(tilted.warnings, "");
    const desc::TextureId id =
        tilted.material(tilted.scene.shapes.front().material).normal_map.texture;
    ASSERT_GE(id, 0) << map;
    const desc::Node& texture = tilted.scene.textures.at(static_cast<std::size_t>(id)).node;
    ASSERT_TRUE(texture.is("constant"));
    EXPECT_EQ(texture.color("value"), Vec3(0.9F, 0.5F, 0.8F));
  }
}

TEST(MitsubaMaterials, MetalsOfVersionsForGlintsHaveTheirReflectance) {
  const MaterialOf metal(
      "<bsdf type=\"roughconductorGGX\"><float name=\"alpha\" value=\"0.3\"/><rgb name=\"R0\" "
      "value=\"0.9 0.6 0.3\"/></bsdf>");
  ASSERT_TRUE(metal.node().is("conductor"));
  EXPECT_EQ(metal.node().color("reflectance"), Vec3(0.9F, 0.6F, 0.3F));
  EXPECT_EQ(metal.node().number("roughness"), 0.3F);
  EXPECT_EQ(metal.node().text("distribution"), "ggx");
  EXPECT_TRUE(contains(metal.warnings, "a metal of that reflectance stands in")) << metal.warnings;
}

TEST(MitsubaMaterials, NormalMapsTiltTheirNestedMaterial) {
  const MaterialOf tilted("<bsdf type=\"normalmap\">" + kNormalMap +
                          "<bsdf type=\"diffuse\"/></bsdf>");
  EXPECT_EQ(tilted.warnings, "");
  const desc::NormalMap& map = tilted.material(tilted.scene.shapes.front().material).normal_map;
  ASSERT_NE(map.texture, desc::kNone);
  EXPECT_TRUE(map.right_handed);
  EXPECT_EQ(map.strength, 1.F);
  EXPECT_FALSE(
      tilted.scene.textures[static_cast<std::size_t>(map.texture)].node.flag("decode_srgb"));
  // The relief of a mix is that of its first part: where the other has another, that is said.
  const auto blend = [](const std::string& second) {
    return MaterialOf("<bsdf type=\"blendbsdf\"><bsdf type=\"normalmap\">" + kNormalMap +
                          "<bsdf type=\"diffuse\"/></bsdf>" + second + "</bsdf>",
                      {{"n.png", ""}})
        .warnings;
  };
  EXPECT_TRUE(contains(blend("<bsdf type=\"diffuse\"/>"), "differ in their bump or normal map"));
  EXPECT_FALSE(contains(blend("<bsdf type=\"null\"/>"), "differ in their bump or normal map"));
  // The relief of a mix is that of its first part.
  const MaterialOf mask("<bsdf type=\"normalmap\">" + kNormalMap +
                        "<bsdf type=\"mask\"><bsdf type=\"diffuse\"/></bsdf></bsdf>");
  ASSERT_TRUE(mask.node().is("mix"));
  EXPECT_NE(mask.material(mask.node().material("first")).normal_map.texture, desc::kNone);
  EXPECT_TRUE(
      contains(MaterialOf("<bsdf type=\"normalmap\">" + kNormalMap + "<bsdf type=\"bumpmap\">" +
                          kNormalMap + "<bsdf type=\"diffuse\"/></bsdf></bsdf>")
                   .warnings,
               "the bump or normal map in this one is not supported"));
  // The file may be its own, as in the renderer of Zeltner et al. 2020.
  const MaterialOf file(
      "<bsdf type=\"normalmap\"><string name=\"filename\" value=\"n.exr\"/><bsdf "
      "type=\"diffuse\"/></bsdf>");
  EXPECT_EQ(file.warnings, "");
  EXPECT_NE(file.material(file.scene.shapes.front().material).normal_map.texture, desc::kNone);
  EXPECT_TRUE(
      contains(MaterialOf("<bsdf type=\"normalmap\"><bsdf type=\"diffuse\"/></bsdf>").warnings,
               "bsdf \"normalmap\" has no texture in it"));
}

TEST(MitsubaMaterials, NumbersThatAreInNoPairOfASpectrumAreIgnoredWithAWarning) {
  const auto read = [](const std::string& file) {
    const MaterialOf material(
        "<bsdf type=\"diffuse\"><spectrum name=\"reflectance\" filename=\"a.spd\"/></bsdf>",
        {{"a.spd", file}});
    return std::pair(material.node().color("reflectance"), material.warnings);
  };
  const auto [even, nothing] = read("300 .5\n500 .25\n800 .5\n");
  EXPECT_EQ(nothing, "");
  for (const char* file : {"300 .5\n500 .25\n800 .5\n900\n", "300 .5\n500 .25 7\n800 .5\n"}) {
    const auto [odd, warning] = read(file);
    EXPECT_EQ(odd, even) << file;
    EXPECT_TRUE(contains(warning, "numbers that are in no pair")) << warning;
  }
  EXPECT_TRUE(contains(read("300\n500 .25\n").second, "a wavelength and a value are expected"));
}

TEST(MitsubaMaterials, OnlyOpenShapesWithoutTwoSidesAreRemarked) {
  const auto remarks = [](const std::string& shape, const std::string& bsdf) {
    return contains(warnings_of("<shape type=\"" + shape + "\">" + bsdf + "</shape>"),
                    "black from behind");
  };
  const std::string diffuse = "<bsdf type=\"diffuse\"/>";
  EXPECT_TRUE(remarks("rectangle", diffuse));
  EXPECT_FALSE(remarks("cube", diffuse));
  EXPECT_FALSE(remarks("rectangle", "<bsdf type=\"twosided\">" + diffuse + "</bsdf>"));
  EXPECT_FALSE(remarks("rectangle", "<bsdf type=\"dielectric\"/>"));
  EXPECT_FALSE(remarks("rectangle",
                       "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0\"/></bsdf>"));
}

TEST(MitsubaMaterials, UnknownOnesAreDiffuseWithAWarning) {
  const MaterialOf odd(
      "<bsdf type=\"dielectrik\"><rgb name=\"reflectance\" value=\"0.2\"/></bsdf>");
  EXPECT_TRUE(contains(odd.warnings,
                       "test.xml:2:22: unknown bsdf \"dielectrik\"; did you mean "
                       "\"dielectric\"?"))
      << odd.warnings;
  EXPECT_EQ(odd.node().color("reflectance"), Vec3(0.2F));
  EXPECT_TRUE(contains(MaterialOf("<bsdf type=\"ward\"/>").warnings, "\"ward\" is not supported"));
}

TEST(MitsubaMaterials, PrincipledHasMitsubasNames) {
  const MaterialOf disney(
      "<bsdf type=\"principled\"><rgb name=\"base_color\" value=\"0.1 0.2 0.3\"/><float "
      "name=\"spec_trans\" value=\"0.5\"/><float name=\"specular\" value=\"0.5\"/></bsdf>");
  expect_near(disney.node().color("base_color"), {0.1F, 0.2F, 0.3F});
  EXPECT_EQ(disney.node().number("specular_transmission"), 0.5F);
  EXPECT_NEAR(disney.node().number("eta"), 1.5F, 1e-5F);
  EXPECT_EQ(disney.node().number("clearcoat_gloss"), 0.F);
}

TEST(MitsubaMaterials, ThinPrincipledIsASplitSheet) {
  const auto number = [](const std::string& name) {
    return "<float name=\"" + name + "\" value=\"0.25\"/>";
  };
  const MaterialOf plain("<bsdf type=\"principledthin\"/>");
  EXPECT_EQ(plain.warnings, "");
  EXPECT_TRUE(plain.node().flag("thin"));
  EXPECT_EQ(plain.node().number("diffuse_transmission"), 0.F);
  const MaterialOf leaf("<bsdf type=\"principledthin\">" + number("diff_trans") +
                        number("spec_trans") + number("specular_reflectance_sampling_rate") +
                        number("specular_transmittance_sampling_rate") +
                        number("diffuse_reflectance_sampling_rate") +
                        number("diffuse_transmittance_sampling_rate") + "</bsdf>");
  EXPECT_EQ(leaf.warnings, "");
  EXPECT_EQ(leaf.node().number("diffuse_transmission"), 0.25F);
  EXPECT_EQ(leaf.node().number("specular_transmission"), 0.25F);
  // Parameters of only one of the two.
  EXPECT_TRUE(contains(
      MaterialOf("<bsdf type=\"principledthin\">" + number("metallic") + "</bsdf>").warnings,
      "has no property \"metallic\""));
  EXPECT_TRUE(
      contains(MaterialOf("<bsdf type=\"principled\">" + number("diff_trans") + "</bsdf>").warnings,
               "has no property \"diff_trans\""));
}

TEST(MitsubaMaterials, PrincipledIsDarkFromBehindUnlessItTransmits) {
  const auto warnings = [](const std::string& numbers) {
    return warnings_of("<shape type=\"rectangle\"><bsdf type=\"principled\">" + numbers +
                       "</bsdf></shape>");
  };
  const auto number = [](const std::string& name, const std::string& value) {
    return "<float name=\"" + name + "\" value=\"" + value + "\"/>";
  };
  EXPECT_TRUE(contains(warnings(""), "test.xml:2:25: this material is black from behind"));
  for (const char* share : {"1", "0.5"}) EXPECT_EQ(warnings(number("spec_trans", share)), "");
  EXPECT_EQ(warnings_of("<shape type=\"rectangle\"><bsdf type=\"twosided\"><bsdf "
                        "type=\"principled\"/></bsdf></shape>"),
            "");
  EXPECT_EQ(warnings_of("<shape type=\"rectangle\"><bsdf type=\"principledthin\"/></shape>"), "");
}

TEST(MitsubaMaterials, WordsMayHaveCapitals) {
  const MaterialOf rough(
      "<bsdf type=\"roughconductor\"><string name=\"distribution\" value=\"GGX\"/><string "
      "name=\"material\" value=\"None\"/></bsdf>");
  EXPECT_EQ(rough.warnings, "");
  EXPECT_EQ(rough.node().text("distribution"), "ggx");
  EXPECT_NEAR(rough.node().color("k").x, 1.F, 1e-3F);
  const MaterialOf image(
      "<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\"><string "
      "name=\"filename\" value=\"a.png\"/><string name=\"filterType\" value=\"Nearest\"/><string "
      "name=\"wrapMode\" value=\"Clamp\"/><string name=\"channel\" value=\"R\"/><boolean "
      "name=\"raw\" value=\"TRUE\"/></texture></bsdf>");
  EXPECT_EQ(image.warnings, "");
  EXPECT_EQ(image.texture("reflectance").text("filter"), "nearest");
  EXPECT_EQ(image.texture("reflectance").text("wrap"), "clamp");
  EXPECT_EQ(image.texture("reflectance").text("channel"), "red");
  EXPECT_FALSE(image.texture("reflectance").flag("decode_srgb"));
}

TEST(MitsubaMaterials, TransmittersHaveTwoNamesForTheirTransmittance) {
  const MaterialOf leaf(
      "<bsdf type=\"difftrans\"><rgb name=\"diffuseTransmittance\" value=\"0.25\"/></bsdf>");
  EXPECT_EQ(leaf.warnings, "");
  EXPECT_EQ(leaf.node().color("diffuse"), Vec3(0.25F));
}

TEST(MitsubaTextures, CountVFromTheTopRow) {
  const auto bitmap = [](const std::string& more) {
    return MaterialOf(
        "<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\"><string "
        "name=\"filename\" value=\"a.png\"/>" +
        more + "</texture></bsdf>");
  };
  const MaterialOf plain = bitmap("");
  EXPECT_EQ(plain.warnings, "");
  // Ours counts from the bottom row: v' = 1 - v.
  EXPECT_EQ(plain.texture("reflectance").number("scale_v"), -1.F);
  EXPECT_EQ(plain.texture("reflectance").number("offset_v"), 1.F);
  EXPECT_TRUE(plain.texture("reflectance").flag("decode_srgb"));
  const MaterialOf scaled = bitmap(
      "<float name=\"uscale\" value=\"2\"/><float name=\"vscale\" value=\"3\"/><float "
      "name=\"voffset\" value=\"0.25\"/><float name=\"gamma\" value=\"1\"/>");
  EXPECT_EQ(scaled.texture("reflectance").number("scale_u"), 2.F);
  EXPECT_EQ(scaled.texture("reflectance").number("scale_v"), -3.F);
  EXPECT_EQ(scaled.texture("reflectance").number("offset_v"), 0.75F);
  EXPECT_FALSE(scaled.texture("reflectance").flag("decode_srgb"));
  EXPECT_EQ(bitmap("<float name=\"gamma\" value=\"2.2\"/>")
                .texture("reflectance")
                .get("decoding_exponent"),
            desc::Value(2.2F));
  EXPECT_FALSE(std::holds_alternative<float>(bitmap("<float name=\"gamma\" value=\"-1\"/>")
                                                 .texture("reflectance")
                                                 .get("decoding_exponent")));
  const MaterialOf moved = bitmap(
      "<transform name=\"to_uv\"><scale x=\"4\" y=\"5\"/><translate x=\"0.5\"/></transform>"
      "<boolean name=\"raw\" value=\"true\"/><string name=\"wrap_mode\" value=\"clamp\"/>");
  EXPECT_EQ(moved.warnings, "");
  EXPECT_EQ(moved.texture("reflectance").number("scale_u"), 4.F);
  EXPECT_EQ(moved.texture("reflectance").number("offset_u"), 0.5F);
  EXPECT_EQ(moved.texture("reflectance").text("wrap"), "clamp");
  EXPECT_FALSE(moved.texture("reflectance").flag("decode_srgb"));
}

TEST(MitsubaTextures, CheckerboardsHaveTwoSquaresPerUnit) {
  const MaterialOf board(
      "<bsdf type=\"diffuse\"><texture type=\"checkerboard\" name=\"reflectance\"/></bsdf>");
  EXPECT_EQ(board.texture("reflectance").number("scale_u"), 2.F);
  EXPECT_EQ(board.texture("reflectance").color("first"), Vec3(0.4F));
  Warnings warnings;
  std::string text = world(
      sphere_of("<bsdf type=\"blendbsdf\"><texture type=\"checkerboard\" name=\"weight\"/><bsdf "
                "type=\"dielectric\"/><bsdf type=\"null\"/></bsdf>"));
  text.replace(text.find("3.0.0"), 5, "0.6.0");
  const desc::Node weight = import_with(text, warnings).textures.at(0).node;
  EXPECT_NEAR(weight.color("first").x, 0.4F, 1e-6F) << "the same as a number before version 2";
}

TEST(MitsubaMaterials, AbsorbingCoatsAreWarnings) {
  const auto coat = [](const std::string& base) {
    return MaterialOf(
        "<bsdf type=\"coating\"><rgb name=\"sigma_a\" value=\"1 2 3\"/><float "
        "name=\"thickness\" value=\"2\"/><bsdf type=\"" +
        base + "\"/></bsdf>");
  };
  EXPECT_EQ(coat("diffuse").node().get("coat_depth"), desc::Value(Vec3(2.F, 4.F, 6.F)));
  EXPECT_EQ(coat("roughconductor").node().get("coat_depth"), desc::Value(Vec3(2.F, 4.F, 6.F)));
  EXPECT_TRUE(contains(coat("roughconductor").warnings, "absorbs as much light from all sides"));
  EXPECT_TRUE(contains(coat("roughdiffuse").warnings, "rough diffuse base below a coat"));
  EXPECT_TRUE(coat("roughdiffuse").node().is("coated_diffuse"));
}

TEST(MitsubaMaterials, MetalsBlackInMitsubaAreWarnings) {
  const auto warns = [](const std::string& numbers) {
    return contains(MaterialOf("<bsdf type=\"principled\">" + numbers + "</bsdf>").warnings,
                    "in Mitsuba metal is black with a \"specular\" of 0");
  };
  const auto number = [](const std::string& name, const std::string& value) {
    return "<float name=\"" + name + "\" value=\"" + value + "\"/>";
  };
  const std::string metal = number("metallic", "0.5");
  EXPECT_TRUE(warns(metal + number("specular", "0")));
  EXPECT_TRUE(warns(metal + number("eta", "1")));
  EXPECT_FALSE(warns(metal + number("specular", "0.001")));
  EXPECT_FALSE(warns(metal + number("specular", "0") + number("spec_trans", "0.5")));
  EXPECT_FALSE(warns(number("specular", "0")));
}

TEST(MitsubaMaterials, ReliefsKnowTheWordsOfNewerVersions) {
  for (const char* type : {"bumpmap", "normalmap"}) {
    for (const char* word : {"use_shadowing_function", "flip_invalid_normals"}) {
      const auto warnings = [&](const char* value) {
        return MaterialOf("<bsdf type=\"" + std::string(type) + "\"><boolean name=\"" + word +
                          "\" value=\"" + value +
                          "\"/><texture type=\"checkerboard\"/><bsdf type=\"diffuse\"/></bsdf>")
            .warnings;
      };
      EXPECT_EQ(warnings("false"), "") << type;
      EXPECT_TRUE(contains(warnings("true"), std::string(word) + "\" is not supported")) << type;
    }
  }
}

}  // namespace
}  // namespace ajar::mitsuba
