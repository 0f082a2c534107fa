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
  ASSERT_TRUE(s.shapes[0].light);
  EXPECT_EQ(s.shapes[0].light->radiance, desc::Rgb(2.F, 4.F, 6.F));
  EXPECT_TRUE(s.shapes[0].light->two_sided);
  EXPECT_TRUE(s.shapes[0].reverse_orientation);
  EXPECT_FALSE(s.shapes[1].light);
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
  const auto spot = std::get<desc::SpotLight>(light.node);
  EXPECT_EQ(spot.cone_angle, 40.F);
  EXPECT_EQ(spot.falloff_start, 35.F);
  EXPECT_NEAR(spot.intensity.x, 139.8F, 0.5F);
}

TEST(PbrtLights, DistantOnesPointBackToWhereTheLightComesFrom) {
  const desc::SceneDesc s = scene_of(
      "LightSource \"distant\" \"point from\" [0 10 0] \"point to\" [0 0 0] \"rgb L\" [3 3 3]");
  EXPECT_NEAR(length(transform_vector(s.lights[0].to_world, {0.F, 0.F, 1.F}) - Vec3(0.F, 1.F, 0.F)),
              0.F, 1e-6F);
  EXPECT_EQ(std::get<desc::DistantLight>(s.lights[0].node).irradiance, desc::Rgb(3.F));
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
  EXPECT_EQ(std::get<desc::InfiniteLight>(s.lights[0].node).image, "sky.exr");
  EXPECT_EQ(std::get<desc::InfiniteLight>(s.lights[0].node).radiance, desc::Rgb(2.F, 4.F, 6.F));
  EXPECT_EQ(std::get<desc::ProjectionLight>(s.lights[1].node).fov, 20.F);
  EXPECT_EQ(std::get<desc::GoniometricLight>(s.lights[2].node).image, "sky.exr");
  EXPECT_TRUE(contains(error_of(world("LightSource \"sun\"")), "unknown light \"sun\""));
  EXPECT_TRUE(contains(warnings_of(world("LightSource \"point\" \"rgb I\" [1 -1 1]")),
                       "\"I\" is negative"));
}

}  // namespace
}  // namespace ajar
