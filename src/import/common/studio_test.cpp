#include "import/common/studio.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/desc/models.h"

namespace ajar {
namespace {

/// A box as the corners of triangles, placed by `to_world`.
desc::SceneDesc box(const Vec3& low, const Vec3& high, const Mat4& to_world = {}) {
  auto mesh = std::make_shared<desc::Mesh>();
  for (unsigned i = 0; i < 8; ++i) {
    mesh->positions.emplace_back((i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y,
                                 (i & 4U) != 0 ? high.z : low.z);
  }
  for (unsigned i = 0; i + 2 < 8; ++i) mesh->indices.emplace_back(i, i + 1, i + 2);
  desc::SceneDesc scene;
  scene.shapes.emplace_back().node = desc::mesh_node(mesh);
  scene.shapes.back().to_world = to_world;
  return scene;
}

std::size_t count_of(const desc::SceneDesc& scene, const std::string& name) {
  std::size_t count = 0;
  for (const desc::Shape& shape : scene.shapes) count += shape.name == name ? 1 : 0;
  return count;
}

TEST(Studio, IncludesTheBoundsOfQuadrics) {
  desc::SceneDesc scene;
  Mat4 move;
  move.setTranslation(Vec3d(5.0, 0.0, 0.0));
  scene.shapes.emplace_back().node = desc::shape_node("sphere", {{"radius", 2.F}});
  scene.shapes.back().to_world = move;
  scene.shapes.emplace_back().node =
      desc::shape_node("cylinder", {{"radius", 1.F}, {"z_min", -3.F}, {"z_max", 4.F}});
  scene.shapes.emplace_back().node = desc::shape_node("disk", {{"radius", 0.5F}, {"height", -6.F}});
  EXPECT_EQ(bounds_of_shapes(scene).min, Vec3d(-1, -2, -6));
  EXPECT_EQ(bounds_of_shapes(scene).max, Vec3d(7, 2, 4));
}

TEST(Studio, AddsOnlyWhatIsMissing) {
  struct Case {
    SceneParts parts;
    bool has_emission;
    std::size_t softboxes, tables;
  };
  for (const Case& c : {Case{{false, false}, false, 2, 1}, Case{{false, false}, true, 2, 1},
                        Case{{true, false}, false, 2, 0}, Case{{true, false}, true, 0, 0},
                        Case{{false, true}, false, 0, 0}, Case{{true, true}, false, 0, 0}}) {
    desc::SceneDesc scene = box(Vec3(0.F), Vec3(1.F));
    if (c.has_emission) scene.shapes[0].emission = desc::Emission{{}, desc::emission_node("area")};
    const Mat4 before = scene.camera.to_world;
    add_studio(scene, c.parts, UpAxis::Y);
    EXPECT_EQ(count_of(scene, "softbox"), c.softboxes);
    EXPECT_EQ(count_of(scene, "table"), c.tables);
    EXPECT_EQ(scene.camera.to_world == before, c.parts.has_camera);
  }
}

TEST(Studio, CameraSeesTheWholeModelAndLittleElse) {
  for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
    for (const Vec3& high : {Vec3(1, 1, 1), Vec3(300, 1, 1), Vec3(0.001F, 5, 0.002F)}) {
      desc::SceneDesc scene = box(Vec3(0.F), high);
      add_studio(scene, {}, up);
      const auto& camera = std::get<desc::PerspectiveCamera>(scene.camera.node);
      const double slope = std::tan(double{camera.fov} * M_PI / 360);
      const Mat4 from_world = scene.camera.to_world.inverse();
      double most = 0.0;
      for (const Vec3& corner : scene.shapes[0].node.mesh("mesh")->positions) {
        const Vec3 p = transform_point(from_world, corner);
        ASSERT_GT(p.z, 0.F);
        most = std::max({most, double{std::abs(p.x / p.z)}, double{std::abs(p.y / p.z)}});
      }
      EXPECT_LT(most, slope);
      EXPECT_GT(most, 0.7 * slope);
    }
  }
}

TEST(Studio, CameraIsUprightAndLeftHanded) {
  desc::SceneDesc scene = box(Vec3(-1.F), Vec3(1.F));
  add_studio(scene, {}, UpAxis::Z);
  const Mat4& m = scene.camera.to_world;
  EXPECT_TRUE(swaps_handedness(m));
  EXPECT_NEAR(m[0][2], 0.0, 1e-12) << "x is level";
  EXPECT_GT(m[1][2], 0.0) << "y points up";
  EXPECT_LT(m[2][2], 0.0) << "it looks down";
  EXPECT_LT(m[3][1], 0.0) << "it is in front, at -y";
}

TEST(Studio, TableIsJustBelowTheModelAndSoftboxesFaceIt) {
  Mat4 to_world;
  to_world.setTranslation(Vec3d(5, 7, 9));
  desc::SceneDesc scene = box(Vec3(0.F), Vec3(2.F), to_world);
  add_studio(scene, {}, UpAxis::Y);
  for (const desc::Shape& shape : scene.shapes) {
    const Vec3 origin = transform_point(shape.to_world, Vec3(0.F));
    const Vec3 normal = transform_vector(shape.to_world, {0, 0, 1});
    if (shape.name == "table") {
      EXPECT_LT(origin.y, 7.F);
      EXPECT_GT(origin.y, 6.99F);
      EXPECT_NEAR(normal.y, 1.F, 1e-6F);
    } else if (shape.name == "softbox") {
      EXPECT_NEAR(dot(normalize(Vec3(6, 8, 10) - origin), normal), 1.F, 1e-5F);
    }
  }
}

TEST(Studio, InstancesCountForTheBounds) {
  desc::SceneDesc scene = box(Vec3(0.F), Vec3(1.F));
  scene.objects.push_back({"", {}, std::move(scene.shapes)});
  scene.shapes.clear();
  Mat4 far;
  far.setTranslation(Vec3d(10, 0, 0));
  scene.instances.push_back({0, Mat4(), {}});
  scene.instances.push_back({0, far, {}});
  EXPECT_EQ(bounds_of_shapes(scene).max, Vec3d(11, 1, 1));
}

TEST(Studio, ScenesWithoutMeshesAndPointsHaveOneToo) {
  desc::SceneDesc scene;
  add_studio(scene, {}, UpAxis::Y);
  EXPECT_TRUE(std::isfinite(scene.camera.to_world[3][0]));
}

}  // namespace
}  // namespace ajar
