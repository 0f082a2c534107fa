// Lights: pbrt-v3's defaults and meanings.
#include <gtest/gtest.h>

#include "import/pbrt/import_test_support.h"

namespace ajar {
namespace {

TEST(PbrtLights, AreaLightsBelongToShapes) {
  const desc::SceneDesc s = scene_of(
      "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [1 2 3] \"rgb scale\" [2 2 2] \"bool "
      "twosided\" \"true\" \"integer nsamples\" 4 "
      "ReverseOrientation Shape \"disk\" AttributeEnd");
  ASSERT_TRUE(s.shapes[0].emission);
  const desc::Node& emission = s.shapes[0].emission->node;
  EXPECT_EQ(emission.color("radiance"), desc::Rgb(1.F, 2.F, 3.F));
  EXPECT_EQ(emission.color("scale"), desc::Rgb(2.F));
  EXPECT_TRUE(emission.flag("two_sided"));
  EXPECT_TRUE(s.shapes[0].reverse_orientation);
  EXPECT_FALSE(s.shapes[1].emission);
  EXPECT_FALSE(s.shapes[1].reverse_orientation);
}

TEST(PbrtLights, SpotsPointFromTo) {
  const desc::SceneDesc s = scene_of(
      "Translate 100 0 0 LightSource \"spot\" \"point from\" [0 5 0] \"point to\" [0 0 0] \"float "
      "coneangle\" 40 \"blackbody I\" [5500 125]");
  const desc::Light& light = s.lights[0];
  EXPECT_NEAR(length(transform_point(light.to_world, {0.F, 0.F, 0.F}) - Vec3(100.F, 5.F, 0.F)), 0.F,
              1e-5F);
  EXPECT_NEAR(length(transform_vector(light.to_world, {0.F, 0.F, 1.F}) - Vec3(0.F, -1.F, 0.F)), 0.F,
              1e-6F);
  EXPECT_TRUE(light.node.is("spot"));
  EXPECT_EQ(light.node.number("cone_angle"), 40.F);
  EXPECT_EQ(light.node.number("falloff_start"), 35.F);
  EXPECT_NEAR(light.node.color("intensity").x, 139.8F, 0.5F);
  const desc::SceneDesc plain = scene_of("LightSource \"spot\"");
  EXPECT_EQ(plain.lights[0].node.number("cone_angle"), 30.F);
  EXPECT_EQ(plain.lights[0].node.number("falloff_start"), 25.F);
}

TEST(PbrtLights, DistantOnesPointBackToWhereTheLightComesFrom) {
  const desc::SceneDesc s = scene_of(
      "LightSource \"distant\" \"point from\" [0 10 0] \"point to\" [0 0 0] \"rgb L\" [3 3 3]");
  EXPECT_NEAR(length(transform_vector(s.lights[0].to_world, {0.F, 0.F, 1.F}) - Vec3(0.F, 1.F, 0.F)),
              0.F, 1e-6F);
  EXPECT_EQ(s.lights[0].node.color("irradiance"), desc::Rgb(3.F));
}

TEST(PbrtLights, PointsAreMovedInWorldSpaceAsInPbrt) {
  const desc::SceneDesc s = scene_of("Scale 10 10 10 LightSource \"point\" \"point from\" [1 2 3]");
  EXPECT_NEAR(length(transform_point(s.lights[0].to_world, {0.F, 0.F, 0.F}) - Vec3(1.F, 2.F, 3.F)),
              0.F, 1e-5F);
}

TEST(PbrtLights, MapsAreResolved) {
  const desc::SceneDesc s = scene_of(
      "LightSource \"infinite\" \"string mapname\" \"sky.exr\" \"rgb scale\" [1 2 3] \"rgb L\" [2 "
      "2 2] \"integer samples\" 8 "
      "LightSource \"projection\" \"string mapname\" \"sky.exr\" \"float fov\" 20 LightSource "
      "\"goniometric\" \"string mapname\" \"sky.exr\"",
      {{"sky.exr", ""}});
  EXPECT_TRUE(s.lights[0].node.is("environment"));
  EXPECT_EQ(s.lights[0].node.text("image"), "sky.exr");
  EXPECT_EQ(s.lights[0].node.color("radiance"), desc::Rgb(2.F, 4.F, 6.F));
  EXPECT_EQ(s.lights[1].node.number("fov"), 20.F);
  EXPECT_EQ(s.lights[2].node.text("image"), "sky.exr");
  EXPECT_TRUE(contains(error_of(world("LightSource \"sun\"")), "unknown light \"sun\""));
  EXPECT_TRUE(contains(warnings_of(world("LightSource \"point\" \"rgb I\" [1 -1 1]")),
                       "\"I\" is negative"));
  EXPECT_TRUE(contains(warnings_of(world("AreaLightSource \"diffuse\" \"rgb L\" [1 -1 1]")),
                       "\"L\" is negative"));
}

TEST(PbrtLights, ImagesOfIntegersAreDecodedWithAWarning) {
  const auto warnings = [](const std::string& file) {
    return warnings_of(world("LightSource \"infinite\" \"string mapname\" \"" + file + "\""));
  };
  EXPECT_TRUE(contains(warnings("sky.PNG"), "test.pbrt:2:1: pbrt-v3 takes the integers"));
  EXPECT_EQ(warnings("sky.exr"), "");
}

TEST(PbrtLights, UnusableOnesHaveLocatedWarnings) {
  EXPECT_TRUE(contains(error_of(world("LightSource \"projection\" \"float fov\" 180")),
                       "2:1: \"fov\" must be between 0 and 180, both excluded, not 180"));
  EXPECT_TRUE(contains(error_of(world("LightSource \"point\" \"rgb I\" [1e30 1 1] \"rgb scale\" "
                                      "[1e30 1 1]")),
                       "2:1: the light is too strong"));
  EXPECT_TRUE(contains(warnings_of(world("LightSource \"spot\" \"point to\" [0 0 0]")),
                       "are the same point: light left out"));
  EXPECT_TRUE(contains(warnings_of(world("LightSource \"point\" \"float coneangle\" 3")),
                       "unused parameter \"float coneangle\""));
}

}  // namespace
}  // namespace ajar
