#pragma once
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/warnings.h"
#include "scene/desc/models.h"
#include "scene/geometry.h"
#include "scene/testing/transforms.h"
#include "scene/texture/texture.h"

/// Shapes of a few triangles, and their geometry.
namespace ajar::testing {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

inline desc::Shape shape(desc::Node node, const Mat4& to_world = Mat4()) {
  desc::Shape result;
  result.node = std::move(node);
  result.to_world = to_world;
  return result;
}
inline desc::Shape mesh_shape(desc::Mesh mesh, const Mat4& to_world = Mat4()) {
  return shape(desc::mesh_node(std::make_shared<const desc::Mesh>(std::move(mesh))), to_world);
}

/// The cube [−1, 1]³, normals outward.
inline desc::Mesh cube() {
  desc::Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back((i & 1) != 0 ? 1.F : -1.F, (i & 2) != 0 ? 1.F : -1.F,
                                (i & 4) != 0 ? 1.F : -1.F);
  }
  const unsigned quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& q : quads) {
    mesh.indices.emplace_back(q[0], q[1], q[2]);
    mesh.indices.emplace_back(q[0], q[2], q[3]);
  }
  return mesh;
}
/// The square [−size, size]² at z = 0 with texture coordinates from 0 to 1.
inline desc::Mesh square(float size) {
  desc::Mesh mesh;
  for (const Vec2& uv : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
    mesh.positions.emplace_back((2 * uv.x - 1) * size, (2 * uv.y - 1) * size, 0.F);
    mesh.uvs.push_back(uv);
  }
  mesh.indices.emplace_back(0, 1, 2);
  mesh.indices.emplace_back(0, 2, 3);
  return mesh;
}

/// A scene as its geometry is built.
struct World {
  explicit World(desc::SceneDesc description) : scene(std::move(description)) {
    textures = build_textures(scene, warnings);
    geometry = std::make_unique<Geometry>(scene, textures, warnings);
  }
  std::optional<GeometryHit> hit(const Vec3& o, const Vec3& d, float t_max = kInfinity) const {
    GeometryHit found;
    if (!geometry->intersect({o, normalize(d), t_max}, found)) return std::nullopt;
    return found;
  }
  bool occluded(const Vec3& o, const Vec3& d, float t_max = kInfinity) const {
    return geometry->occluded({o, normalize(d), t_max});
  }
  desc::SceneDesc scene;
  Warnings warnings;
  TextureList textures;
  std::unique_ptr<Geometry> geometry;
};

inline desc::SceneDesc scene_of(std::vector<desc::Shape> shapes) {
  desc::SceneDesc scene;
  scene.shapes = std::move(shapes);
  return scene;
}
inline World world_of(std::vector<desc::Shape> shapes) {
  return World(scene_of(std::move(shapes)));
}

}  // namespace ajar::testing
