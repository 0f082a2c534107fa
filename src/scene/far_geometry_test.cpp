#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/random.h"
#include "scene/desc/models.h"
#include "scene/geometry.h"
#include "scene/testing/quadrics.h"
#include "scene/testing/small_world.h"

/// Geometry as large, as far or as small as floats have it.
namespace ajar {
namespace {

using testing::cube;
using testing::kInfinity;
using testing::mesh_shape;
using testing::scaling;
using testing::scene_of;
using testing::shape;
using testing::translation;
using testing::World;
using testing::world_of;

std::string error_of(desc::SceneDesc scene) {
  const SourceLocation where{std::make_shared<const std::string>("scene.pbrt"), 7, 1};
  for (desc::Shape& shape : scene.shapes) shape.where = where;
  for (desc::Instance& instance : scene.instances) instance.where = where;
  try {
    World{std::move(scene)};
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

TEST(FarGeometry, ShapesBeyondTheLimitAreLocatedErrors) {
  const std::string beyond = "but no more than 6e+17 can be rendered: scale the scene down";
  EXPECT_EQ(error_of(scene_of({mesh_shape(cube(), scaling(1e30, 1e30, 1e30))})),
            "scene.pbrt:7:1: vertex 0 of the mesh has coordinates of 1e+30, " + beyond);
  EXPECT_EQ(error_of(scene_of({shape(testing::sphere_node(), translation(0, -1e18, 0))})),
            "scene.pbrt:7:1: the shape has coordinates of 1e+18, " + beyond);
  EXPECT_EQ(error_of(scene_of({shape(testing::disk_node(0.F, 1e38F))})),
            "scene.pbrt:7:1: the shape has coordinates of 1e+38, " + beyond);
  auto curve = std::make_shared<desc::Curves>();
  curve->control_points = {Vec3(0.F), Vec3(1.F), Vec3(2.F), Vec3(1e19F, 0.F, 0.F)};
  curve->widths = {1, 1, 1, 1};
  EXPECT_EQ(error_of(scene_of({shape(desc::shape_node("curves", {{"curves", curve}}))})),
            "scene.pbrt:7:1: control point 3 of the curve has coordinates of 1e+19, " + beyond);
}

TEST(FarGeometry, IsHitWithinTheLimit) {
  const World world = world_of({shape(testing::sphere_node(2e17F, -2e17F, 2e17F, 360.F)),
                                mesh_shape(cube(), translation(0, 0, -5e17))});
  const auto found = world.hit({0.F, 0.F, 1e18F}, {0, 0, -1});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->shape, 0U);
  EXPECT_NEAR(found->t, 8e17F, 1e12F);
}

/// Each of these rays ends the program in builds of Embree with assertions.
TEST(FarGeometry, RaysOutOfRangeAreNotTraced) {
  const World world = world_of({mesh_shape(cube())});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Ray> rays = {{{0, 0, 1.9e18F}, {0, 0, -1}},    {{0, -kInfinity, 0}, {0, 1, 0}},
                                 {{nan, 0, 5}, {0, 0, -1}},        {{0, 0, 5}, {0, 0, nan}},
                                 {{0, 0, 5}, {-kInfinity, 0, -1}}, {{0, 0, 5}, {0, 0, -1e19F}},
                                 {{0, 0, 5}, {0, 0, -1}, nan}};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    GeometryHit hit;
    EXPECT_FALSE(world.geometry->can_trace(rays[i])) << i;
    EXPECT_FALSE(world.geometry->intersect(rays[i], hit)) << i;
    EXPECT_TRUE(world.geometry->occluded(rays[i])) << i;
  }
  EXPECT_TRUE(world.geometry->can_trace({{0, 0, kMaxRayCoordinate}, {0, 0, -1}}));
  EXPECT_TRUE(world.hit({0, 0, kMaxRayCoordinate}, {0, 0, -1}));
}

desc::SceneDesc instance_of_cube(const Mat4& to_world) {
  desc::SceneDesc scene;
  scene.objects.push_back({"cube", {}, {mesh_shape(cube())}});
  scene.instances.push_back({0, to_world, {}});
  return scene;
}

TEST(FarGeometry, InstancesBeyondTheLimitAreLocatedErrors) {
  EXPECT_EQ(error_of(instance_of_cube(translation(0, 1e18, 0))),
            "scene.pbrt:7:1: the instance has coordinates of 1e+18, but no more than 6e+17 can be "
            "rendered: scale the scene down");
  EXPECT_EQ(error_of(instance_of_cube(scaling(1, 1e19, 1))),
            "scene.pbrt:7:1: the instance has coordinates of 1e+19, but no more than 6e+17 can be "
            "rendered: scale the scene down");
}

/// Rays become as much longer in the space of an instance as it is smaller.
TEST(FarGeometry, SmallInstancesLimitTheRaysOfTheirScene) {
  for (const double size : {1e-3, 1e-9, 1e-12}) {
    SCOPED_TRACE(size);
    desc::SceneDesc scene = instance_of_cube(scaling(size, size, size));
    const World world(std::move(scene));
    const auto limit = static_cast<float>(size * 9.2e17);
    const Vec3 w(0, 0, -1);
    EXPECT_TRUE(world.hit({0, 0, 0.9F * limit}, w));
    EXPECT_FALSE(world.geometry->can_trace({{0, 0, 1.1F * limit}, w}));
    EXPECT_NO_THROW(world.geometry->require_reach(0.9 * double{limit}, instance_of_cube(Mat4())));
    EXPECT_THROW(world.geometry->require_reach(1.1 * double{limit}, instance_of_cube(Mat4())),
                 SceneError);
  }
}

TEST(FarGeometry, InstancesThatSinglePrecisionCannotInvertAreErrors) {
  for (const double size : {1e-30, 1e-13, 1e13}) {
    SCOPED_TRACE(size);
    const World world(instance_of_cube(scaling(size, size, size)));
    EXPECT_FALSE(world.geometry->can_trace({{0, 0, 5}, {0, 0, -1}}));
    EXPECT_THROW(world.geometry->require_reach(0.0, instance_of_cube(Mat4())), SceneError);
  }
}

/// Random transforms whose float inverse is as bad as is let through.
TEST(FarGeometry, AcceptedScenesCanBeTraced) {
  Rng rng(9);
  const auto random = [&] { return 2.0 * rng.next() - 1.0; };
  int kept = 0;
  for (int i = 0; i < 3000; ++i) {
    Mat4 m;
    for (int row = 0; row < 3; ++row) {
      const double size = std::pow(10.0, 6.0 * random());
      for (int k = 0; k < 3; ++k) m[row][k] = size * random();
    }
    if (i % 2 == 0) {
      // Nearly singular.
      const double away = std::pow(10.0, -8.0 * rng.next());
      for (int k = 0; k < 3; ++k) m[2][k] = m[0][k] - m[1][k] + away * m[2][k];
    }
    const World world(instance_of_cube(m));
    const Ray ray{Vec3(static_cast<float>(random()), static_cast<float>(random()), 1.F) * 1e6F,
                  normalize(Vec3(static_cast<float>(random()), static_cast<float>(random()), -1))};
    if (world.geometry->can_trace(ray)) ++kept;
    GeometryHit hit;
    world.geometry->intersect(ray, hit);  // must not end the program
    world.geometry->occluded(ray);
  }
  EXPECT_GT(kept, 2000);
}

}  // namespace
}  // namespace ajar
