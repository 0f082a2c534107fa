#pragma once
#include <optional>
#include <string>

#include "scene/desc/models.h"
#include "scene/shape/build_shape.h"

/// Quadrics for tests, with the order of parameters of their models.
namespace ajar::testing {

/// Quadric of a node, in its own space; nothing if it has no area.
inline std::optional<Quadric> quadric_of(const desc::Node& node) {
  desc::Shape shape;
  shape.node = node;
  Warnings warnings;
  const BuiltShape built = build_shape(shape, *Placement::make(Mat4()), warnings);
  const Quadric* quadric = std::get_if<Quadric>(&built);
  return quadric == nullptr ? std::nullopt : std::optional(*quadric);
}

inline desc::Node sphere_node(float radius = 1, float z_min = -1, float z_max = 1,
                              float phi_max = 360) {
  return desc::shape_node(
      "sphere", {{"radius", radius}, {"z_min", z_min}, {"z_max", z_max}, {"phi_max", phi_max}});
}
inline desc::Node disk_node(float height = 0, float radius = 1, float inner_radius = 0,
                            float phi_max = 360) {
  return desc::shape_node("disk", {{"height", height},
                                   {"radius", radius},
                                   {"inner_radius", inner_radius},
                                   {"phi_max", phi_max}});
}
inline desc::Node disk_node_of(const std::string& coordinates) {
  desc::Node node = disk_node(0.5F, 2, 0.7F, 250);
  node.set("coordinates", coordinates);
  return node;
}
inline desc::Node cylinder_node(float radius = 1, float z_min = -1, float z_max = 1,
                                float phi_max = 360) {
  return desc::shape_node(
      "cylinder", {{"radius", radius}, {"z_min", z_min}, {"z_max", z_max}, {"phi_max", phi_max}});
}
inline desc::Node cone_node(float radius = 1, float height = 1, float phi_max = 360) {
  return desc::shape_node("cone", {{"radius", radius}, {"height", height}, {"phi_max", phi_max}});
}
inline desc::Node paraboloid_node(float radius = 1, float z_min = 0, float z_max = 1,
                                  float phi_max = 360) {
  return desc::shape_node(
      "paraboloid", {{"radius", radius}, {"z_min", z_min}, {"z_max", z_max}, {"phi_max", phi_max}});
}
inline desc::Node hyperboloid_node(const Vec3& p1, const Vec3& p2, float phi_max = 360) {
  return desc::shape_node("hyperboloid", {{"p1", p1}, {"p2", p2}, {"phi_max", phi_max}});
}

}  // namespace ajar::testing
