#include "import/pbrt/shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "import/mesh/validate_mesh.h"

namespace ajar::pbrt {
namespace {

const std::vector<std::string> kTypes = {"trianglemesh", "plymesh", "sphere",      "disk",
                                         "cylinder",     "cone",    "paraboloid",  "hyperboloid",
                                         "loopsubdiv",   "curve",   "heightfield", "nurbs"};
constexpr WarningKind kLeftOut{Effect::Geometry, "shapes are left out"};
constexpr WarningKind kOddIndices{Effect::Slight,
                                  "meshes have indices left over, which are ignored"};
/// More triangles than this are certainly a mistake in the file.
constexpr double kMostTriangles = 1e9;

/// Everything that one `Shape` directive says.
struct Source {
  Context& context;
  const SourceLocation& where;
  const ParameterList& parameters;

  std::optional<ShapeNode> skip(const std::string& reason) const {
    context.warnings.add(kLeftOut, where, reason + ": shape left out", reason);
    return std::nullopt;
  }
  float phi_max() const { return std::clamp(parameters.get_float("phimax", 360.F), 0.F, 360.F); }
};

std::vector<Imath::Vec3<unsigned>> indices_of(const Source& source) {
  const Parameter* p = source.parameters.find("indices", ParameterKind::Integer);
  if (p == nullptr) return {};
  if (p->integers.size() % 3 != 0) {
    source.context.warnings.add(
        kOddIndices, p->where,
        "the number of indices is not a multiple of 3: the last ones ignored");
  }
  std::vector<Imath::Vec3<unsigned>> result(p->integers.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i) {
    // Negative numbers become large ones, which are out of range as well.
    result[i] = {static_cast<unsigned>(p->integers[3 * i]),
                 static_cast<unsigned>(p->integers[3 * i + 1]),
                 static_cast<unsigned>(p->integers[3 * i + 2])};
  }
  return result;
}

/// False if nothing is left of it.
bool validate(const Source& source, desc::Mesh& mesh) {
  std::vector<Warning> remarks;
  validate_mesh(mesh, source.where, remarks);
  for (Warning& remark : remarks) source.context.warnings.add(std::move(remark));
  return !mesh.indices.empty();
}

std::optional<ShapeNode> finish_mesh(const Source& source, desc::Mesh mesh) {
  if (!validate(source, mesh)) return std::nullopt;
  return std::make_shared<const desc::Mesh>(std::move(mesh));
}

std::optional<ShapeNode> triangle_mesh(const Source& source) {
  const ParameterList& p = source.parameters;
  desc::Mesh mesh;
  mesh.positions = p.get_points("P");
  mesh.indices = indices_of(source);
  mesh.normals = p.get_normals("N");
  mesh.tangents = p.get_vectors("S");
  mesh.uvs = p.get_point2s("uv");
  if (mesh.uvs.empty()) mesh.uvs = p.get_point2s("st");
  p.accept({"faceIndices", "discarddegenerateUVs"});
  if (mesh.positions.empty()) throw SceneError(source.where, "a trianglemesh needs \"point P\"");
  if (mesh.indices.empty()) {
    if (mesh.positions.size() != 3)
      throw SceneError(source.where, "a trianglemesh needs \"integer indices\"");
    mesh.indices = {{0, 1, 2}};
  }
  return finish_mesh(source, std::move(mesh));
}

std::optional<ShapeNode> ply_mesh(const Source& source, MeshLoader& meshes) {
  const std::optional<std::string> name = source.parameters.get_string("filename");
  if (!name || name->empty()) throw SceneError(source.where, "a plymesh needs \"string filename\"");
  return meshes.request(source.where, *name);
}

std::optional<ShapeNode> loop_subdivision(const Source& source) {
  const ParameterList& p = source.parameters;
  desc::LoopSubdivision node;
  node.levels = p.get_int("levels", p.get_int("nlevels", 3));
  node.control.positions = p.get_points("P");
  node.control.indices = indices_of(source);
  p.accept({"scheme"});
  if (node.control.positions.empty())
    throw SceneError(source.where, "a loopsubdiv needs \"point P\"");
  if (node.control.indices.empty())
    throw SceneError(source.where, "a loopsubdiv needs \"integer indices\"");
  const auto faces = static_cast<double>(node.control.indices.size());
  if (node.levels < 0 || faces * std::pow(4.0, node.levels) > kMostTriangles) {
    throw SceneError(source.where,
                     "\"levels\" of " + std::to_string(node.levels) + " make no sense here");
  }
  if (!validate(source, node.control)) return std::nullopt;
  return std::make_shared<const desc::LoopSubdivision>(std::move(node));
}

/// pbrt's height field: z over the unit square, two triangles per cell.
std::optional<ShapeNode> height_field(const Source& source) {
  const ParameterList& p = source.parameters;
  const int nu = p.get_int("nu", -1);
  const int nv = p.get_int("nv", -1);
  const Parameter* heights = p.find("Pz", ParameterKind::Float);
  if (nu < 2 || nv < 2 || heights == nullptr ||
      heights->numbers.size() != static_cast<std::size_t>(nu) * static_cast<std::size_t>(nv)) {
    throw SceneError(source.where,
                     "a heightfield needs \"integer nu\" and \"integer nv\", 2 or more, and nu × "
                     "nv \"float Pz\"");
  }
  desc::Mesh mesh;
  for (int y = 0; y < nv; ++y) {
    for (int x = 0; x < nu; ++x) {
      const Vec2 uv(static_cast<float>(x) / static_cast<float>(nu - 1),
                    static_cast<float>(y) / static_cast<float>(nv - 1));
      mesh.positions.emplace_back(uv.x, uv.y, heights->numbers[mesh.positions.size()]);
      mesh.uvs.push_back(uv);
    }
  }
  for (int y = 0; y + 1 < nv; ++y) {
    for (int x = 0; x + 1 < nu; ++x) {
      const auto vertex = [&](int dx, int dy) {
        return static_cast<unsigned>((y + dy) * nu + x + dx);
      };
      mesh.indices.emplace_back(vertex(0, 0), vertex(1, 0), vertex(1, 1));
      mesh.indices.emplace_back(vertex(0, 0), vertex(1, 1), vertex(0, 1));
    }
  }
  return finish_mesh(source, std::move(mesh));
}

std::optional<ShapeNode> sphere(const Source& source) {
  desc::Sphere node;
  node.radius = source.parameters.get_float("radius", 1.F);
  const float z0 = source.parameters.get_float("zmin", -node.radius);
  const float z1 = source.parameters.get_float("zmax", node.radius);
  node.phi_max = source.phi_max();
  if (!(node.radius > 0.F)) return source.skip("the radius is not positive");
  node.z_min = std::clamp(std::min(z0, z1), -node.radius, node.radius);
  node.z_max = std::clamp(std::max(z0, z1), -node.radius, node.radius);
  if (!(node.z_min < node.z_max)) return source.skip("zmin equals zmax");
  return node;
}

std::optional<ShapeNode> disk(const Source& source) {
  desc::Disk node;
  node.height = source.parameters.get_float("height", 0.F);
  node.radius = source.parameters.get_float("radius", 1.F);
  node.inner_radius = source.parameters.get_float("innerradius", 0.F);
  node.phi_max = source.phi_max();
  if (!(node.radius > 0.F)) return source.skip("the radius is not positive");
  if (!(node.inner_radius >= 0.F && node.inner_radius < node.radius)) {
    return source.skip("the inner radius is not between 0 and the radius");
  }
  return node;
}

std::optional<ShapeNode> cylinder(const Source& source) {
  desc::Cylinder node;
  node.radius = source.parameters.get_float("radius", 1.F);
  const float z0 = source.parameters.get_float("zmin", -1.F);
  const float z1 = source.parameters.get_float("zmax", 1.F);
  node.z_min = std::min(z0, z1);
  node.z_max = std::max(z0, z1);
  node.phi_max = source.phi_max();
  if (!(node.radius > 0.F)) return source.skip("the radius is not positive");
  if (!(node.z_min < node.z_max)) return source.skip("zmin equals zmax");
  return node;
}

std::optional<ShapeNode> cone(const Source& source) {
  desc::Cone node;
  node.radius = source.parameters.get_float("radius", 1.F);
  node.height = source.parameters.get_float("height", 1.F);
  node.phi_max = source.phi_max();
  if (!(node.radius > 0.F && node.height > 0.F))
    return source.skip("radius or height is not positive");
  return node;
}

std::optional<ShapeNode> paraboloid(const Source& source) {
  desc::Paraboloid node;
  node.radius = source.parameters.get_float("radius", 1.F);
  const float z0 = source.parameters.get_float("zmin", 0.F);
  const float z1 = source.parameters.get_float("zmax", 1.F);
  node.z_min = std::min(z0, z1);
  node.z_max = std::max(z0, z1);
  node.phi_max = source.phi_max();
  if (!(node.radius > 0.F && node.z_max > 0.F))
    return source.skip("radius or zmax is not positive");
  if (!(node.z_min < node.z_max)) return source.skip("zmin equals zmax");
  return node;
}

std::optional<ShapeNode> hyperboloid(const Source& source) {
  desc::Hyperboloid node;
  node.p1 = source.parameters.get_point("p1", {0.F, 0.F, 0.F});
  node.p2 = source.parameters.get_point("p2", {1.F, 1.F, 1.F});
  node.phi_max = source.phi_max();
  if (node.p1 == node.p2) return source.skip("p1 equals p2");
  return node;
}

}  // namespace

std::optional<ShapeNode> make_shape(Context& context, MeshLoader& meshes,
                                    const SourceLocation& where, const std::string& type,
                                    const ParameterList& parameters) {
  const Source source{context, where, parameters};
  if (type == "trianglemesh") return triangle_mesh(source);
  if (type == "plymesh") return ply_mesh(source, meshes);
  if (type == "sphere") return sphere(source);
  if (type == "disk") return disk(source);
  if (type == "cylinder") return cylinder(source);
  if (type == "cone") return cone(source);
  if (type == "paraboloid") return paraboloid(source);
  if (type == "hyperboloid") return hyperboloid(source);
  if (type == "loopsubdiv") return loop_subdivision(source);
  if (type == "curve") return make_curve(context, where, parameters);
  if (type == "heightfield") return height_field(source);
  if (type == "nurbs") return source.skip("nurbs are not supported");
  fail_unknown(where, "shape", type, kTypes);
}

}  // namespace ajar::pbrt
