#include "import/pbrt/emitted_power.h"

#include <algorithm>
#include <cmath>

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUneven{
    Effect::Light,
    "lights have \"power\" for each of their triangles, which differ in size: the mean is used"};
constexpr WarningKind kNoArea{Effect::Light,
                              "lights have \"power\" on shapes of unknown area: it is ignored"};

struct Areas {
  double sum = 0.0;
  double least = 0.0, most = 0.0;  ///< bounds for a primitive
  std::size_t primitives = 0;
  void add(double area) {
    least = primitives == 0 ? area : std::min(least, area);
    most = std::max(most, area);
    sum += area;
    ++primitives;
  }
};

/// In the world, where all triangles live.
Areas areas_of(const desc::Mesh& mesh, const Mat4& to_world, std::size_t triangles_per_primitive) {
  Areas areas;
  double primitive = 0.0;
  std::size_t triangles = 0;
  for (const auto& triangle : mesh.indices) {
    const Vec3d a = Vec3d(mesh.positions[triangle.x]) * to_world;
    const Vec3d b = Vec3d(mesh.positions[triangle.y]) * to_world;
    const Vec3d c = Vec3d(mesh.positions[triangle.z]) * to_world;
    primitive += 0.5 * (b - a).cross(c - a).length();
    if (++triangles % triangles_per_primitive != 0) continue;
    areas.add(primitive);
    primitive = 0.0;
  }
  return areas;
}

/// In the shape's own space: pbrt-v4 does not expect quadrics that shine to be scaled.
Areas area_of_quadric(const desc::Node& node) {
  const auto end = [&](const char* name, float whole) {
    const float* given = std::get_if<float>(&node.get(name));
    return static_cast<double>(given == nullptr ? whole : *given);
  };
  Areas areas;
  if (!node.has("phi_max") || !node.has("radius")) return areas;
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  const double phi = static_cast<double>(node.number("phi_max")) * kRadians;
  const float radius = node.number("radius");
  const auto r = static_cast<double>(radius);
  if (node.is("disk")) {
    const auto inner = static_cast<double>(node.number("inner_radius"));
    areas.add(0.5 * phi * (r * r - inner * inner));
  } else if (node.is("sphere") || node.is("cylinder")) {
    areas.add(phi * r * std::abs(end("z_max", radius) - end("z_min", -radius)));
  }
  return areas;
}

}  // namespace

void scale_to_power(desc::Shape& shape, float power, std::size_t triangles_per_primitive,
                    Warnings& warnings) {
  desc::Node& emission = shape.emission->node;
  const Areas areas = shape.node.is("mesh") ? areas_of(*shape.node.mesh("mesh"), shape.to_world,
                                                       triangles_per_primitive)
                                            : area_of_quadric(shape.node);
  if (!(areas.sum > 0.0)) {
    warnings.add(kNoArea, shape.emission->where,
                 "\"power\" of a light on a shape of unknown area is ignored");
    return;
  }
  if (areas.most > 1.01 * areas.least) {
    warnings.add(kUneven, shape.emission->where,
                 "\"power\" is that of each triangle, and their sizes differ: the mean is used");
  }
  const double sides = emission.flag("two_sided") ? 2.0 : 1.0;
  const double mean = areas.sum / static_cast<double>(areas.primitives);
  const auto factor =
      static_cast<float>(static_cast<double>(power) / (sides * 3.14159265358979323846 * mean));
  emission.set("scale", emission.color("scale") * factor);
}

}  // namespace ajar::pbrt
