// Lights of pbrt-v4: units, places, images.
#include <cmath>

#include "import/pbrt/v4_test_support.h"

namespace ajar {
namespace {

constexpr float kPi4 = 4.F * 3.14159265F;

desc::Light light_of(const std::string& body) {
  return v4_scene(body, {{"sky.exr", ""}}).lights.at(0);
}
desc::Rgb scale_of(const std::string& body) {
  return v4_scene(body).shapes.at(0).emission->node.color("scale");
}

TEST(Pbrt4Lights, PowerIsTheTotalFlux) {
  expect_rgb(light_of("LightSource \"point\" \"float power\" 100").node.color("intensity"),
             desc::Rgb(100.F / kPi4), 1e-4F);
  // The colour of the light multiplies its power.
  expect_rgb(light_of("LightSource \"point\" \"rgb I\" [2 2 2] \"float power\" 100")
                 .node.color("intensity"),
             desc::Rgb(200.F / kPi4), 1e-4F);
  const auto cosine = [](double degrees) { return std::cos(degrees * M_PI / 180); };
  const double solid_angle = 2 * M_PI * ((1 - cosine(30)) + (cosine(30) - cosine(40)) / 2);
  expect_rgb(light_of("LightSource \"spot\" \"float power\" 10 \"float coneangle\" 40 \"float "
                      "conedeltaangle\" 10")
                 .node.color("intensity"),
             desc::Rgb(static_cast<float>(10 / solid_angle)), 1e-4F);
  EXPECT_EQ(light_of("LightSource \"point\" \"float power\" -1").node.color("intensity"),
            desc::Rgb(1.F));
}

TEST(Pbrt4Lights, PowerOfImagesIsAParameter) {
  EXPECT_TRUE(
      light_of("LightSource \"goniometric\" \"string filename\" \"sky.exr\"").node.flag("gray"));
  EXPECT_EQ(light_of("LightSource \"goniometric\" \"string filename\" \"sky.exr\" "
                     "\"float power\" 5")
                .node.number("power"),
            5.F);
  EXPECT_EQ(light_of("LightSource \"projection\" \"string filename\" \"sky.exr\" "
                     "\"float power\" 5")
                .node.number("power"),
            5.F);
  EXPECT_EQ(light_of("LightSource \"infinite\" \"string filename\" \"sky.exr\" "
                     "\"float illuminance\" 5")
                .node.number("irradiance"),
            5.F);
}

TEST(Pbrt4Lights, IlluminanceScalesDistantLight) {
  expect_rgb(light_of("LightSource \"distant\" \"rgb L\" [1 1 .5] \"float illuminance\" 10")
                 .node.color("irradiance"),
             {10.F, 10.F, 5.F}, 1e-5F);
}

TEST(Pbrt4Lights, SkiesAreSquares) {
  const desc::Node sky =
      light_of("LightSource \"infinite\" \"string filename\" \"sky.exr\" \"float scale\" 2").node;
  EXPECT_EQ(sky.text("projection"), "equal_area");
  EXPECT_EQ(sky.text("image"), "sky.exr");
  EXPECT_EQ(sky.color("radiance"), desc::Rgb(2.F));
  EXPECT_TRUE(contains(v4_warnings("LightSource \"infinite\" \"rgb L\" [1 1 1] \"point3 portal\" "
                                   "[0 0 0 1 0 0 1 1 0 0 1 0]"),
                       "test.pbrt:2:1: the portal of this light is ignored"));
}

TEST(Pbrt4Lights, HaveTheirPlaceInTheCurrentTransform) {
  // pbrt-v3 would put this one at (1, 2, 3).
  const desc::Light point =
      light_of("Scale 10 10 10 LightSource \"point\" \"point3 from\" [1 2 3]");
  EXPECT_LT(length(transform_point(point.to_world, Vec3(0.F)) - Vec3(10.F, 20.F, 30.F)), 1e-4F);
  const desc::Light slide = light_of("LightSource \"projection\" \"string filename\" \"sky.exr\"");
  EXPECT_EQ(slide.node.number("fov"), 90.F);
  // Our row 0 is at −y, which is up in the world then.
  EXPECT_EQ(transform_vector(slide.to_world, {0.F, -1.F, 0.F}), Vec3(0.F, 1.F, 0.F));
  EXPECT_EQ(transform_vector(slide.to_world, {1.F, 0.F, 1.F}), Vec3(1.F, 0.F, 1.F));
}

TEST(Pbrt4Lights, SpotsFadeSmoothly) {
  EXPECT_EQ(light_of("LightSource \"spot\"").node.text("falloff"), "smoothstep");
}

TEST(Pbrt4AreaLights, HaveScaleAndSides) {
  const desc::SceneDesc s = v4_scene(
      "AreaLightSource \"diffuse\" \"rgb L\" [3 2 1] \"float scale\" 4 \"bool twosided\" true "
      "Shape \"disk\"");
  const desc::Node& node = s.shapes[0].emission->node;
  EXPECT_EQ(node.color("radiance"), desc::Rgb(3.F, 2.F, 1.F));
  EXPECT_EQ(node.color("scale"), desc::Rgb(4.F));
  EXPECT_TRUE(node.flag("two_sided"));
}

TEST(Pbrt4AreaLights, PowerIsThatOfEachPrimitive) {
  const float pi = kPi4 / 4.F;
  const std::string light = "AreaLightSource \"diffuse\" \"float power\" 12 ";
  // A disk of radius 2 has the area 4 π.
  expect_rgb(scale_of(light + "Shape \"disk\" \"float radius\" 2"),
             desc::Rgb(12.F / (pi * 4.F * pi)), 1e-5F);
  expect_rgb(scale_of("AreaLightSource \"diffuse\" \"float power\" 12 \"bool twosided\" true "
                      "Shape \"sphere\""),
             desc::Rgb(12.F / (2.F * pi * 4.F * pi)), 1e-5F);
  // Two triangles of area 2, each with all of the power.
  const std::string square =
      "\"point3 P\" [0 0 0 1 0 0 1 1 0 0 1 0] \"integer indices\" [0 1 2 0 2 3]";
  expect_rgb(scale_of(light + "Scale 2 2 2 Shape \"trianglemesh\" " + square),
             desc::Rgb(12.F / (pi * 2.F)), 1e-5F);
  // One patch of area 4.
  expect_rgb(scale_of(light + "Scale 2 2 2 Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 "
                              "1 1 0]"),
             desc::Rgb(12.F / (pi * 4.F)), 1e-5F);
  EXPECT_TRUE(
      contains(v4_warnings(light + "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 9 9 0] "
                                   "\"integer indices\" [0 1 2 0 2 3]"),
               "their sizes differ"));
}

TEST(Pbrt4AreaLights, ImagesShineAsTextures) {
  const desc::SceneDesc s = v4_scene(
      "AreaLightSource \"diffuse\" \"string filename\" \"sky.exr\" \"float scale\" 3 Shape "
      "\"disk\"",
      {{"sky.exr", ""}});
  const desc::Node& node = s.shapes[0].emission->node;
  EXPECT_EQ(s.textures[static_cast<std::size_t>(node.texture("radiance"))].node.text("file"),
            "sky.exr");
  EXPECT_EQ(node.color("scale"), desc::Rgb(3.F));
}

TEST(Pbrt4Lights, HaveAColorOrAnImage) {
  const Files files = {{"sky.exr", ""}};
  const std::string both = "\"rgb L\" [2 2 2] \"string filename\" \"sky.exr\" ";
  EXPECT_TRUE(contains(v4_warnings("LightSource \"infinite\" " + both, files),
                       "2:24: pbrt-v4 refuses \"L\" beside an image: here it is a factor"));
  EXPECT_TRUE(contains(v4_warnings("AreaLightSource \"diffuse\" " + both, files),
                       "2:27: pbrt-v4 refuses \"L\" beside an image: here the image counts"));
}

TEST(Pbrt4Lights, AreDarkWhereTheirScaleIsNegative) {
  const std::string point = "LightSource \"point\" \"float scale\" -2";
  EXPECT_TRUE(contains(v4_warnings(point), "2:21: \"scale\" of a light is negative"));
  EXPECT_EQ(v4_scene_with_warnings(point).lights.at(0).node.color("intensity"), desc::Rgb(0.F));
}

TEST(Pbrt4Lights, UnknownOnesAreLeftOut) {
  EXPECT_TRUE(contains(v4_warnings("LightSource \"poitn\""),
                       "test.pbrt:2:1: unknown light \"poitn\"; did you mean \"point\"?"));
  EXPECT_TRUE(v4_scene_with_warnings("LightSource \"sun\"").lights.empty());
}

}  // namespace
}  // namespace ajar
