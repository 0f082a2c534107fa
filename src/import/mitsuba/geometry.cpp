#include "import/mitsuba/geometry.h"

#include <array>
#include <cmath>

#include "core/printable_text.h"
#include "import/common/transforms.h"
#include "import/mitsuba/plugin_types.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kShapesLeftOut{Effect::Geometry, "shapes are left out"};

std::optional<Geometry> skip(const Arguments& arguments, const std::string& reason) {
  arguments.context().warnings.add(kShapesLeftOut, arguments.where(), reason + ": shape left out",
                                   printable(arguments.element().type));
  return std::nullopt;
}

desc::Node node_of(desc::Mesh mesh) {
  return desc::mesh_node(std::make_shared<const desc::Mesh>(std::move(mesh)));
}

/// A square with its texture coordinates: the corner where both are 0, and its sides along u and v.
struct Square {
  Vec3 corner, u, v;
};

/// The normal is u × v, or v × u.
void add_square(desc::Mesh& mesh, const Square& square, bool faces_u_cross_v) {
  const auto first = static_cast<unsigned>(mesh.positions.size());
  for (const Vec2& uv : {Vec2(0.F, 0.F), Vec2(1.F, 0.F), Vec2(1.F, 1.F), Vec2(0.F, 1.F)}) {
    mesh.positions.push_back(square.corner + square.u * uv.x + square.v * uv.y);
    mesh.uvs.push_back(uv);
  }
  const unsigned a = faces_u_cross_v ? 1 : 3;
  const unsigned b = faces_u_cross_v ? 3 : 1;
  mesh.indices.emplace_back(first, first + a, first + 2);
  mesh.indices.emplace_back(first, first + 2, first + b);
}

Geometry rectangle() {
  desc::Mesh mesh;
  add_square(mesh, {{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, true);
  return {node_of(std::move(mesh)), Mat4()};
}

Geometry cube() {
  // Mitsuba's texture coordinates of the sides.
  static const std::array<Square, 6> kSides = {{{{-1, -1, -1}, {0, 0, 2}, {2, 0, 0}},
                                                {{1, 1, 1}, {-2, 0, 0}, {0, 0, -2}},
                                                {{1, -1, 1}, {0, 2, 0}, {0, 0, -2}},
                                                {{-1, -1, 1}, {0, 2, 0}, {2, 0, 0}},
                                                {{-1, -1, -1}, {0, 2, 0}, {0, 0, 2}},
                                                {{-1, 1, -1}, {0, -2, 0}, {2, 0, 0}}}};
  desc::Mesh mesh;
  for (const Square& side : kSides) add_square(mesh, side, false);
  return {node_of(std::move(mesh)), Mat4(), true};
}

std::optional<Geometry> sphere(Arguments& arguments) {
  const float radius = arguments.number("radius", 1.F);
  const Vec3d center = arguments.vector("center").value_or(Vec3d(0.0));
  if (!(radius > 0.F)) return skip(arguments, "the radius of this sphere is not positive");
  // v is 0 at +z in Mitsuba, at -z in our sphere.
  return Geometry{desc::shape_node("sphere", {{"radius", radius}}),
                  scaling({1.0, 1.0, -1.0}) * translation(center), true};
}

Geometry disk() {
  return {desc::shape_node("disk", {{"coordinates", std::string("radius_then_angle")}}), Mat4()};
}

std::optional<Geometry> cylinder(Arguments& arguments) {
  const float radius = arguments.number("radius", 1.F);
  const Vec3d p0 = arguments.vector("p0").value_or(Vec3d(0.0));
  const Vec3d p1 = arguments.vector("p1").value_or(Vec3d(0.0, 0.0, 1.0));
  const std::optional<Mat4> turn = z_to(p1 - p0);
  if (!turn || !(radius > 0.F)) {
    return skip(arguments, "this cylinder has no length, or a radius that is not positive");
  }
  const auto length = static_cast<float>((p1 - p0).length());
  return Geometry{
      desc::shape_node("cylinder", {{"radius", radius}, {"z_min", 0.F}, {"z_max", length}}),
      *turn * translation(p0)};
}

}  // namespace

std::optional<Geometry> make_geometry(Arguments& arguments, MeshLoader& meshes) {
  const std::string& type = arguments.element().type;
  if (type == "obj" || type == "ply" || type == "serialized") {
    return make_mesh_geometry(arguments, meshes);
  }
  if (type == "hair" || type == "linearcurve" || type == "bsplinecurve") {
    return make_curve_geometry(arguments);
  }
  if (type == "rectangle") return rectangle();
  if (type == "cube") return cube();
  if (type == "sphere") return sphere(arguments);
  if (type == "disk") return disk();
  if (type == "cylinder") return cylinder(arguments);
  arguments.accept_all();
  return skip(arguments, unknown_type_message(arguments.element()));
}

}  // namespace ajar::mitsuba
