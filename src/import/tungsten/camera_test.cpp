#include "import/tungsten/camera.h"

#include <gtest/gtest.h>

#include "import/tungsten/import_test_support.h"

namespace ajar::tungsten {
namespace {

desc::SceneDesc scene_with_camera(const std::string& members) {
  return scene_of("", "{'type': 'quad', 'name': 'pivot', 'transform': {'position': [0, 0, 3]}}",
                  "{" + members + "}");
}
const desc::PerspectiveCamera& perspective(const desc::SceneDesc& scene) {
  return std::get<desc::PerspectiveCamera>(scene.camera.node);
}

TEST(TungstenCamera, FovIsThatOfTheWidth) {
  // Veach's lamps: 35° in Tungsten's file, 20.114292° of the height in pbrt's.
  EXPECT_NEAR(perspective(scene_with_camera("'fov': 35, 'resolution': [1280, 720]")).fov,
              20.114292F, 1e-5F);
  EXPECT_EQ(perspective(scene_with_camera("'fov': 35, 'resolution': [720, 1280]")).fov, 35.F);
  EXPECT_EQ(perspective(scene_with_camera("'resolution': 256")).fov, 60.F);
}

TEST(TungstenCamera, SeesXToTheLeft) {
  const desc::SceneDesc scene =
      scene_with_camera("'transform': {'position': [1, 2, 3], 'look_at': [1, 2, 4]}");
  expect_near(moved(scene.camera.to_world, {0, 0, 1}), {1, 2, 4});
  expect_near(moved(scene.camera.to_world, {0, 1, 0}), {1, 3, 3});
  expect_near(moved(scene.camera.to_world, {1, 0, 0}), {0, 2, 3});
}

TEST(TungstenCamera, OlderFilesHaveThePlaceInTheCamera) {
  const desc::SceneDesc scene =
      scene_with_camera("'position': [0, 0, 5], 'lookAt': [0, 0, 0], 'up': [0, 1, 0], 'spp': 7");
  expect_near(moved(scene.camera.to_world, {0, 0, 1}), {0, 0, 4});
  expect_near(moved(scene.camera.to_world, {1, 0, 0}), {1, 0, 5});
}

TEST(TungstenCamera, LensesHaveARadiusAndAFocus) {
  const desc::SceneDesc scene = scene_with_camera(
      "'type': 'thinlens', 'aperture_size': 0.25, 'focus_distance': 2, 'aperture': {'type': "
      "'disk'}");
  EXPECT_EQ(perspective(scene).lens_radius, 0.25F);
  EXPECT_EQ(perspective(scene).focal_distance, 2.F);
  const desc::SceneDesc pivot = scene_with_camera("'type': 'thinlens', 'focus_pivot': 'pivot'");
  EXPECT_EQ(perspective(pivot).focal_distance, 3.F);
}

TEST(TungstenCamera, EquirectangularPicturesHaveForwardAtThreeQuarters) {
  // Tungsten: φ = 2π (u − 1/2) from the right toward forward, which is at u = 3/4.
  const desc::SceneDesc scene = scene_with_camera("'type': 'equirectangular'");
  EXPECT_TRUE(std::holds_alternative<desc::EnvironmentCamera>(scene.camera.node));
  // Ours: φ = 2π u from +x toward +z.
  expect_near(transform_vector(scene.camera.to_world, {0, 0, -1}), {0, 0, 1});
  expect_near(transform_vector(scene.camera.to_world, {-1, 0, 0}), {-1, 0, 0});
}

TEST(TungstenCamera, HasResolutionAndFilter) {
  EXPECT_EQ(scene_with_camera("").film.resolution, Vec2i(1000, 563));
  EXPECT_EQ(scene_with_camera("'resolution': 64").film.resolution, Vec2i(64, 64));
  const auto filter = [](const std::string& name) {
    return scene_with_camera("'reconstruction_filter': '" + name + "'").film.filter;
  };
  EXPECT_EQ(filter("tent").radius, Vec2(1.F, 1.F));
  EXPECT_TRUE(std::holds_alternative<desc::TriangleFilter>(scene_with_camera("").film.filter.node));
  EXPECT_EQ(filter("box").radius, Vec2(0.5F, 0.5F));
  EXPECT_EQ(std::get<desc::GaussianFilter>(filter("gaussian").node).falloff, 2.F);
  EXPECT_EQ(std::get<desc::MitchellFilter>(filter("catmull_rom").node).c, 0.5F);
  EXPECT_EQ(std::get<desc::MitchellFilter>(filter("catmull_rom").node).b, 0.F);
  EXPECT_EQ(std::get<desc::SincFilter>(filter("lanczos").node).lobes, 2.F);
  EXPECT_EQ(filter("mitchell_netravali").radius, Vec2(2.F, 2.F));
}

TEST(TungstenCamera, UnsupportedOptionsAreWarnings) {
  const auto with = [](const std::string& members) {
    return scene_text("", "{'type': 'quad'}", "{" + members + "}");
  };
  EXPECT_TRUE(contains(warnings_of(with("'type': 'pinehole'")), "did you mean \"pinhole\"?"));
  EXPECT_TRUE(contains(warnings_of(with("'type': 'cubemap'")), "\"cubemap\" is not supported"));
  EXPECT_TRUE(contains(warnings_of(with("'reconstruction_filter': 'tend'")),
                       "test.json:1:38#/camera/reconstruction_filter: unknown filter \"tend\"; did "
                       "you mean \"tent\"?"));
  EXPECT_TRUE(contains(warnings_of(with("'type': 'thinlens', 'cateye': 1")), "round lenses"));
  EXPECT_TRUE(contains(warnings_of(with("'type': 'thinlens', 'focus_pivot': 'x'")),
                       "no primitive \"x\" to focus on"));
  EXPECT_TRUE(contains(warnings_of(with("'tonemap': 'filmic'")), "\"tonemap\" is not used"));
  EXPECT_TRUE(contains(error_of(with("'fov': 180")), "between 0 and 180"));
  EXPECT_TRUE(contains(error_of(with("'resolution': [0, 5]")), "must be 1 to 65536, not 0"));
  EXPECT_TRUE(contains(error_of(with("'resolution': 1.5")), "must be a whole number"));
}

}  // namespace
}  // namespace ajar::tungsten
