#include "scene/surface_derivatives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/testing/quadrics.h"
#include "scene/testing/small_world.h"

namespace ajar {
namespace {

using testing::kInfinity;
using testing::scene_of;

struct Case {
  std::string name;
  desc::SceneDesc scene;
  Vec3 origin;
  Vec3 direction;
  double tolerance;  ///< tolerance per radian of rotation, or unit of length
};

/// A square whose normals lean outward.
desc::Mesh leaning_square() {
  desc::Mesh mesh = testing::square(2.F);
  for (const Vec3& p : mesh.positions) {
    mesh.normals.push_back(normalize(Vec3(0.3F * p.x, 0.2F * p.y + 0.1F * p.x, 1.F)));
  }
  return mesh;
}

Mat4 skewed() {
  return testing::scaling(1.0, 1.7, 0.6) * testing::rotation({1.F, 2.F, 3.F}, 0.7) *
         testing::translation(0.2, -0.1, 0.3);
}

desc::SceneDesc instanced(desc::Shape shape, const Mat4& to_world) {
  desc::SceneDesc scene;
  scene.objects.emplace_back();
  scene.objects[0].shapes.push_back(std::move(shape));
  desc::Instance& instance = scene.instances.emplace_back();
  instance.object = 0;
  instance.to_world = to_world;
  return scene;
}

desc::Node round_curve() {
  auto curves = std::make_shared<desc::Curves>();
  curves->control_points = {
      {-2.F, 0.F, 0.F}, {-1.F, 0.6F, 0.2F}, {1.F, -0.4F, 0.1F}, {2.F, 0.2F, 0.F}};
  curves->widths = {0.8F, 1.F, 0.9F, 0.7F};
  return desc::shape_node("curves",
                          {{"type", "cylinder"}, {"curves", desc::CurvesPointer(curves)}});
}

std::vector<Case> cases() {
  std::vector<Case> result;
  const auto add = [&](const char* name, desc::SceneDesc scene, double tolerance = 2e-3) {
    result.push_back(
        {name, std::move(scene), Vec3(0.3F, -0.2F, 5.F), Vec3(0.02F, 0.03F, -1.F), tolerance});
  };
  add("Sphere", scene_of({testing::shape(testing::sphere_node(1.F))}));
  add("Ellipsoid", scene_of({testing::shape(testing::sphere_node(1.F), skewed())}));
  add("Disk", scene_of({testing::shape(testing::disk_node(), skewed())}));
  add("Paraboloid", scene_of({testing::shape(testing::paraboloid_node())}));
  add("Hyperboloid",
      scene_of({testing::shape(testing::hyperboloid_node({1.F, 0.F, -1.F}, {0.2F, 0.9F, 1.F}),
                               testing::rotation({1.F, 0.F, 0.F}, 1.2))}));
  add("FlatTriangles", scene_of({testing::mesh_shape(testing::square(2.F), skewed())}));
  add("LeaningNormals", scene_of({testing::mesh_shape(leaning_square(), skewed())}));
  add("InstancedTriangles", instanced(testing::mesh_shape(leaning_square()), skewed()));
  add("InstancedEllipsoid",
      instanced(testing::shape(testing::sphere_node(1.F), testing::scaling(1.0, 0.8, 1.2)),
                skewed()));
  add("RoundCurve", scene_of({testing::shape(round_curve())}), 2e-2);
  return result;
}

/// Rays beside a ray meet the surface, and its normal, where the derivatives say.
TEST(SurfaceDerivatives, MatchNeighbouringHits) {
  for (Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const testing::World world(std::move(c.scene));
    const auto hit = world.hit(c.origin, c.direction);
    ASSERT_TRUE(hit);
    const auto surface = world.geometry->derivatives(*hit);
    ASSERT_TRUE(surface);
    EXPECT_NEAR((surface->n - Vec3d(hit->point.ns)).length(), 0.0, c.tolerance);
    const Vec3d area = surface->dpdu.cross(surface->dpdv);
    constexpr float kStep = 4e-3F;
    for (const Vec3& side : {Vec3(1.F, 0.F, 0.F), Vec3(0.F, 1.F, 0.F), Vec3(0.7F, -0.7F, 0.F)}) {
      const auto before = world.hit(c.origin - side * kStep, c.direction);
      const auto after = world.hit(c.origin + side * kStep, c.direction);
      ASSERT_TRUE(before && after);
      const Vec3d dp = Vec3d(after->point.p) - Vec3d(before->point.p);
      const Vec3d dn = Vec3d(after->point.ns) - Vec3d(before->point.ns);
      const double du = dp.cross(surface->dpdv).dot(area) / area.dot(area);
      const double dv = surface->dpdu.cross(dp).dot(area) / area.dot(area);
      const Vec3d along = surface->dpdu * du + surface->dpdv * dv;
      EXPECT_LT((along - dp).length(), c.tolerance * dp.length());
      const Vec3d turn = surface->dndu * du + surface->dndv * dv;
      EXPECT_LT((turn - dn).length(), c.tolerance * dp.length()) << turn << " for " << dn;
    }
  }
}

TEST(SurfaceDerivatives, AreEmptyWhereTheSurfaceIsNotSmooth) {
  auto curves = std::make_shared<desc::Curves>();
  curves->control_points = {{-2.F, 0.F, 0.F}, {-1.F, 0.F, 0.F}, {1.F, 0.F, 0.F}, {2.F, 0.F, 0.F}};
  curves->widths = {1.F, 1.F, 1.F, 1.F};
  const auto world = testing::world_of({testing::shape(
      desc::shape_node("curves", {{"type", "flat"}, {"curves", desc::CurvesPointer(curves)}}))});
  const auto hit = world.hit({0.1F, 0.F, 5.F}, {0.F, 0.F, -1.F});
  ASSERT_TRUE(hit);
  EXPECT_FALSE(world.geometry->derivatives(*hit));
}

}  // namespace
}  // namespace ajar
