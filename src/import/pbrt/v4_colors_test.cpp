// Colours of pbrt-v4: spaces, photometric scale of lights, named spectra.
#include "color/color.h"
#include "core/spectrum.h"
#include "import/pbrt/color_space.h"
#include "import/pbrt/v4_test_support.h"

namespace ajar {
namespace {

desc::Rgb light(const std::string& parameters) {
  return v4_scene("LightSource \"point\" " + parameters).lights.at(0).node.color("intensity");
}
desc::Rgb reflectance(const std::string& parameters) {
  return v4_material("Material \"diffuse\" " + parameters).color("reflectance");
}
float luminance_of(const desc::Rgb& rgb) { return luminance(Spectrum(rgb.x, rgb.y, rgb.z)); }

TEST(Pbrt4Colors, SpacesMapWhiteToTheirWhite) {
  for (const std::string& name : pbrt::ColorSpace::names()) {
    const pbrt::ColorSpace& space = *pbrt::ColorSpace::find(name);
    const Vec3d white = space.light_to_rec709(Vec3d(1.0));
    const Vec3d expected = name == "srgb" ? Vec3d(1.0) : xyz_to_rgb(space.white());
    EXPECT_NEAR((white - expected).length(), 0.0, 1e-9) << name;
    EXPECT_NEAR((space.reflectance_to_rec709(Vec3d(1.0)) - Vec3d(1.0)).length(), 0.0, 1e-3) << name;
  }
  EXPECT_EQ(pbrt::ColorSpace::find("adobe"), nullptr);
}

TEST(Pbrt4Colors, SpacesMapTheirPrimaries) {
  // Source: ITU-R BT.2087, table of the matrix from BT.2020 to BT.709.
  const pbrt::ColorSpace& wide = *pbrt::ColorSpace::find("rec2020");
  const Vec3d red = wide.light_to_rec709({1.0, 0.0, 0.0});
  EXPECT_NEAR(red.x, 1.6605, 2e-3);
  EXPECT_NEAR(red.y, -0.1246, 2e-3);
  EXPECT_NEAR(red.z, -0.0182, 2e-3);
  // Source: the ACES Input Transform of BT.709, AMPAS TB-2014-012: the inverse of its first row.
  const pbrt::ColorSpace& aces = *pbrt::ColorSpace::find("aces2065-1");
  const Vec3d red_of_aces = aces.reflectance_to_rec709({1.0, 0.0, 0.0});
  EXPECT_NEAR(red_of_aces.x, 2.52, 0.03);
  EXPECT_NEAR(red_of_aces.y, -0.28, 0.03);
  EXPECT_NEAR(red_of_aces.z, -0.02, 0.03);
}

TEST(Pbrt4Colors, AreOfTheCurrentSpace) {
  const std::string two_lights =
      "AttributeBegin ColorSpace \"rec2020\" LightSource \"point\" \"rgb I\" [0 1 0] AttributeEnd "
      "LightSource \"point\" \"rgb I\" [0 1 0]";
  const desc::SceneDesc scene = v4_scene_with_warnings(two_lights);
  expect_rgb(scene.lights[0].node.color("intensity"), {0.F, 1.1329F, 0.F}, 2e-3F);
  EXPECT_EQ(scene.lights[1].node.color("intensity"), desc::Rgb(0.F, 1.F, 0.F));
  EXPECT_TRUE(contains(v4_warnings(two_lights), "\"I\" is more saturated than sRGB can show"));
  EXPECT_EQ(v4_warnings("ColorSpace \"rec2020\" LightSource \"point\" \"rgb I\" [.4 .5 .4]"), "");
  EXPECT_TRUE(
      contains(v4_warnings("ColorSpace \"rec2022\""),
               "test.pbrt:2:1: unknown colour space \"rec2022\"; did you mean \"rec2020\""));
}

TEST(Pbrt4Colors, RgbOfALightIsWhatAnIdealFilmShows) {
  expect_rgb(light("\"rgb I\" [3 2 1]"), {3.F, 2.F, 1.F});
  expect_rgb(light("\"rgb I\" [3 2 1] \"float scale\" 2"), {6.F, 4.F, 2.F});
  expect_rgb(light(""), {1.F, 1.F, 1.F});
}

TEST(Pbrt4Colors, SpectraOfLightsKeepOnlyTheirChromaticity) {
  for (const char* spectrum :
       {"\"blackbody I\" 3000", "\"blackbody I\" 6500", "\"spectrum I\" [400 5 700 5]",
        "\"spectrum I\" [400 700 700 700]", "\"spectrum I\" \"stdillum-A\"",
        "\"spectrum I\" \"stdillum-F11\""}) {
    EXPECT_NEAR(luminance_of(light(spectrum)), 1.F, 1e-3F) << spectrum;
    EXPECT_NEAR(luminance_of(light(std::string(spectrum) + " \"float scale\" 7")), 7.F, 7e-3F);
  }
  // Tungsten light is a black body of 2856 K.
  expect_rgb(light("\"blackbody I\" 2856"), light("\"spectrum I\" \"stdillum-A\""), 5e-3F);
  expect_rgb(light("\"spectrum I\" \"stdillum-D65\""), {1.F, 1.F, 1.F}, 2e-3F);
  const desc::Rgb warm = light("\"blackbody I\" 3000");
  EXPECT_GT(warm.x, 1.5F);
  EXPECT_LT(warm.z, 0.5F);
}

TEST(Pbrt4Colors, ConstantSpectraOfSurfacesAreGrey) {
  expect_rgb(reflectance("\"spectrum reflectance\" [300 0.3 900 0.3]"), desc::Rgb(0.3F), 1e-5F);
  expect_rgb(reflectance("\"rgb reflectance\" [.1 .2 .3]"), {0.1F, 0.2F, 0.3F});
}

TEST(Pbrt4Colors, MetalsHaveNames) {
  const desc::Node gold = v4_material(
      "Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\"");
  // Handbook values at 630, 550 and 450 nm, which daylight's lanes are near.
  expect_rgb(gold.color("eta"), {0.18F, 0.35F, 1.5F}, 0.25F);
  expect_rgb(gold.color("k"), {3.4F, 2.7F, 1.9F}, 0.4F);
  const desc::Node copper = v4_material("Material \"conductor\"");
  const desc::Node named = v4_material(
      "Material \"conductor\" \"spectrum eta\" \"metal-Cu-eta\" \"spectrum k\" \"metal-Cu-k\"");
  EXPECT_EQ(copper, named);
  const desc::Node coated = v4_material("Material \"coatedconductor\"");
  EXPECT_EQ(coated.color("k"), named.color("k"));
  EXPECT_TRUE(contains(v4_warnings("Material \"conductor\" \"spectrum eta\" \"metal-Ag-etta\""),
                       "did you mean \"metal-Ag-eta\"?"));
}

TEST(Pbrt4Colors, GlassesHaveOneIndex) {
  const std::string glass = "Material \"dielectric\" \"spectrum eta\" \"glass-BK7\"";
  const auto index = [](const std::string& name) {
    const desc::SceneDesc scene =
        v4_scene_with_warnings("Material \"dielectric\" \"spectrum eta\" \"glass-" + name + "\"");
    return material_node_of(scene, scene.shapes.back()).number("eta");
  };
  EXPECT_NEAR(index("F11"), 1.78472F, 1e-4F);
  EXPECT_EQ(index("F5"), index("SF5"));
  EXPECT_EQ(index("F10"), index("SF10"));
  EXPECT_TRUE(contains(v4_warnings(glass), "test.pbrt:2:23: dispersion is not supported"));
  const desc::SceneDesc scene = v4_scene_with_warnings(glass);
  EXPECT_NEAR(material_node_of(scene, scene.shapes.back()).number("eta"), 1.5168F, 1e-4F);
}

TEST(Pbrt4Colors, BlackBodiesHaveNoScaleOfTheirOwn) {
  EXPECT_TRUE(contains(v4_warnings("LightSource \"point\" \"blackbody I\" [3000 2]"),
                       "must have one value, not 2"));
}

}  // namespace
}  // namespace ajar
