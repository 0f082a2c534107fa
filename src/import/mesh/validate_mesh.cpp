#include "import/mesh/validate_mesh.h"

#include <algorithm>
#include <cmath>

namespace ajar {
namespace {

constexpr WarningKind kNoArea{Effect::None, "triangles have no area and are left out", "meshes"};
constexpr WarningKind kEmpty{Effect::Geometry, "meshes have no triangles and are left out"};
constexpr WarningKind kBadAttribute{
    Effect::Surface, "meshes have normals, tangents or texture coordinates that are ignored"};
constexpr WarningKind kLongAttribute{
    Effect::None, "meshes have more normals, tangents or texture coordinates than vertices"};

bool all_finite(const std::vector<Vec3>& vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [](const Vec3& v) { return is_finite(v); });
}
bool all_finite(const std::vector<Vec2>& vectors) {
  return std::all_of(vectors.begin(), vectors.end(),
                     [](const Vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); });
}

bool all_finite(const std::vector<std::int8_t>& /*signs*/) { return true; }

template <typename Vector>
void check_attribute(std::vector<Vector>& attribute, std::size_t vertices, const std::string& name,
                     const SourceLocation& where, std::vector<Warning>& remarks) {
  if (attribute.empty()) return;
  if (attribute.size() < vertices) {
    remarks.push_back({kBadAttribute, where,
                       "mesh has " + std::to_string(vertices) + " vertices but " +
                           std::to_string(attribute.size()) + " " + name + ": " + name +
                           " ignored"});
    attribute.clear();
  } else if (attribute.size() > vertices) {
    remarks.push_back({kLongAttribute, where,
                       "mesh has more " + name + " than vertices: the last " +
                           std::to_string(attribute.size() - vertices) + " ignored"});
    attribute.resize(vertices);
  }
  if (!all_finite(attribute)) {
    remarks.push_back(
        {kBadAttribute, where, "mesh has " + name + " that are not finite: " + name + " ignored"});
    attribute.clear();
  }
}

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  if (n.x != 0.F || n.y != 0.F || n.z != 0.F) return true;
  // Single precision underflows for very small triangles.
  const Vec3d exact = (Vec3d(b) - Vec3d(a)).cross(Vec3d(c) - Vec3d(a));
  return exact.x != 0.0 || exact.y != 0.0 || exact.z != 0.0;
}

}  // namespace

void validate_mesh(desc::Mesh& mesh, const SourceLocation& where, std::vector<Warning>& remarks) {
  const std::size_t vertices = mesh.positions.size();
  for (std::size_t i = 0; i < vertices; ++i) {
    if (!is_finite(mesh.positions[i])) {
      throw SceneError(where,
                       "mesh vertex " + std::to_string(i) + " has a position that is not finite");
    }
  }
  check_attribute(mesh.normals, vertices, "normals", where, remarks);
  check_attribute(mesh.tangents, vertices, "tangents", where, remarks);
  check_attribute(mesh.handedness, vertices, "signs of tangents", where, remarks);
  check_attribute(mesh.uvs, vertices, "texture coordinates", where, remarks);

  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const Imath::Vec3<unsigned> t = mesh.indices[i];
    if (t.x >= vertices || t.y >= vertices || t.z >= vertices) {
      const unsigned bad = std::max({t.x, t.y, t.z});
      throw SceneError(where, "mesh triangle " + std::to_string(i) + " refers to vertex " +
                                  std::to_string(static_cast<int>(bad)) + " of " +
                                  std::to_string(vertices));
    }
    if (has_area(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z])) {
      mesh.indices[kept++] = t;
    }
  }
  if (kept < mesh.indices.size()) {
    const std::size_t dropped = mesh.indices.size() - kept;
    remarks.push_back({kNoArea,
                       where,
                       std::to_string(dropped) + " of " + std::to_string(mesh.indices.size()) +
                           " triangles have no area: dropped",
                       {},
                       dropped});
    mesh.indices.resize(kept);
  }
  if (mesh.indices.empty()) {
    remarks.push_back({kEmpty, where, "this mesh has no triangles: left out"});
  }
}

}  // namespace ajar
