#include "import/tungsten/geometry.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/frame.h"
#include "import/tungsten/transforms.h"
#include "scene/desc/models.h"

namespace ajar::tungsten {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;

double area_of(const desc::Mesh& mesh, const Mat4& transform) {
  double area = 0.0;
  for (const Imath::Vec3<unsigned>& t : mesh.indices) {
    const Vec3d a(transform_point(transform, mesh.positions[t.x]));
    const Vec3d b(transform_point(transform, mesh.positions[t.y]));
    const Vec3d c(transform_point(transform, mesh.positions[t.z]));
    area += 0.5 * (b - a).cross(c - a).length();
  }
  return area;
}

Part mesh_part(desc::Mesh mesh) {
  const double area = area_of(mesh, Mat4());
  Part part;
  part.node = desc::mesh_node(std::make_shared<const desc::Mesh>(std::move(mesh)));
  part.area = area;
  return part;
}

/// A rectangle around `center`, whose normal is `along_u` × `along_v`; both run from edge to edge.
void add_rectangle(desc::Mesh& mesh, const Vec3d& center, const Vec3d& along_u,
                   const Vec3d& along_v) {
  const auto first = static_cast<unsigned>(mesh.positions.size());
  for (const auto& [u, v] : {std::pair{0.F, 0.F}, {1.F, 0.F}, {1.F, 1.F}, {0.F, 1.F}}) {
    mesh.positions.emplace_back(center + along_u * (static_cast<double>(u) - 0.5) +
                                along_v * (static_cast<double>(v) - 0.5));
    mesh.uvs.emplace_back(u, v);
  }
  mesh.indices.emplace_back(first, first + 1, first + 2);
  mesh.indices.emplace_back(first, first + 2, first + 3);
}

Mat4 scaled(const Mat4& transform, double x, double y, double z) {
  return from_axes(axis_of(transform, 0) * x, axis_of(transform, 1) * y, axis_of(transform, 2) * z,
                   origin_of(transform));
}

/// A disk across the y of `frame`, facing it, `height` above.
Part disk_at(const Mat4& frame, double radius, double height) {
  Part part;
  part.node = desc::shape_node("disk");
  const Vec3d x = axis_of(frame, 0);
  const Vec3d y = axis_of(frame, 1);
  part.to_world =
      from_axes(x * radius, y.cross(x) * radius, y * radius, origin_of(frame) + y * height);
  part.area = kPiDouble * radius * radius;
  return part;
}

}  // namespace

Part quad(const Mat4& transform) {
  desc::Mesh mesh;
  add_rectangle(mesh, origin_of(transform), axis_of(transform, 0), -axis_of(transform, 2));
  for (Vec2& uv : mesh.uvs) uv.y = 1.F - uv.y;  // v along z, but the normal is y
  return mesh_part(std::move(mesh));
}

Part cube(const Mat4& transform) {
  desc::Mesh mesh;
  const double handedness = swaps_handedness(transform) ? -1.0 : 1.0;
  for (int i = 0; i < 3; ++i) {
    const Vec3d out = axis_of(transform, i) * 0.5;
    const Vec3d u = axis_of(transform, (i + 1) % 3);
    const Vec3d v = axis_of(transform, (i + 2) % 3);
    for (const double side : {1.0, -1.0}) {
      const std::size_t first = mesh.indices.size();
      add_rectangle(mesh, origin_of(transform) + out * side, u, v);
      if (side * handedness > 0.0) continue;
      for (std::size_t t = first; t < mesh.indices.size(); ++t) {
        std::swap(mesh.indices[t].y, mesh.indices[t].z);
      }
    }
  }
  return mesh_part(std::move(mesh));
}

Part sphere(const Mat4& transform) {
  const Vec3d scale = scale_of(transform);
  const double radius = std::max({scale.x, scale.y, scale.z});
  Part part;
  part.node = desc::shape_node("sphere");
  // Tungsten's u begins half a turn from ours, and its v runs the other way: point by point the
  // opposite of ours.
  part.to_world = scaled(without_scale(transform, true), -radius, -radius, -radius);
  part.area = 4.0 * kPiDouble * radius * radius;
  return part;
}

Part disk(const Mat4& transform) {
  const Vec3d scale = scale_of(transform);
  const Mat4 frame = without_scale(transform, true);
  const double radius = std::max(scale.x, scale.z);
  Part part = disk_at(frame, radius, 0.0);
  // The angle of its texture does not turn with the disk: it begins half a turn from the second
  // axis of a frame around the normal, by Duff et al. 2017, and goes to the first.
  const Frame around = Frame::around(Vec3(axis_of(frame, 1)));
  part.node.set("coordinates", std::string("angle_then_radius"));
  part.to_world = from_axes(Vec3d(around.y) * -radius, Vec3d(around.x) * -radius,
                            axis_of(frame, 1) * radius, origin_of(frame));
  return part;
}

std::vector<Part> cylinder(const Mat4& transform, bool capped) {
  const Vec3d scale = scale_of(transform);
  const double radius = 0.5 * std::max(scale.x, scale.z);
  const double half_height = 0.5 * scale.y;
  const Mat4 frame = without_scale(transform, true);
  const Vec3d x = axis_of(frame, 0);
  const Vec3d y = axis_of(frame, 1);
  const Vec3d z = axis_of(frame, 2);
  Part side;
  side.node = desc::shape_node("cylinder");
  // u begins half a turn from x and goes to z.
  side.to_world = from_axes(x * -radius, z * -radius, y * half_height, origin_of(frame));
  side.area = 4.0 * kPiDouble * radius * half_height;
  std::vector<Part> parts = {std::move(side)};
  if (capped) {
    parts.push_back(disk_at(frame, radius, half_height));
    const Mat4 upside_down = from_axes(x, -y, -z, origin_of(frame));
    parts.push_back(disk_at(upside_down, radius, half_height));
  }
  return parts;
}

Part placed_mesh(desc::MeshPointer mesh, const Mat4& transform) {
  Part part;
  part.area = area_of(*mesh, transform);
  const bool is_mirrored = swaps_handedness(transform);
  (mesh->normals.empty() ? part.reverse_orientation : part.has_turned_winding) = is_mirrored;
  part.node = desc::mesh_node(std::move(mesh));
  part.to_world = transform;
  return part;
}

}  // namespace ajar::tungsten
