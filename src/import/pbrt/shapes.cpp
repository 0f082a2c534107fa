#include "import/pbrt/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "import/mesh/validate_mesh.h"
#include "import/pbrt/bilinear_mesh.h"
#include "import/pbrt/node_reader.h"
#include "import/pbrt/own_words.h"
#include "import/pbrt/shape_names.h"

namespace ajar::pbrt {
namespace {

/// Beside those that are models of ours.
const std::vector<std::string> kOtherTypes = {"plymesh", "heightfield", "nurbs"};
const std::vector<std::string> kOtherTypesOfV4 = {"plymesh", "bilinearmesh"};
constexpr WarningKind kUnknownShape{Effect::Geometry, "shapes are unknown and left out"};
constexpr WarningKind kDisplaced{Effect::Geometry,
                                 "meshes are displaced by images, which is not supported"};
constexpr WarningKind kShapesLeftOut{Effect::Geometry, "shapes are left out"};
constexpr WarningKind kOddIndices{Effect::Slight,
                                  "meshes have indices left over, which are ignored"};
/// More triangles than this are certainly a mistake in the file.
constexpr double kMostTriangles = 1e9;

/// Everything that one `Shape` directive says.
struct Source {
  Context& context;
  const SourceLocation& where;
  const ParameterList& parameters;

  std::optional<desc::Node> skip(const std::string& reason) const {
    context.warnings.add(kShapesLeftOut, where, reason + ": shape left out", reason);
    return std::nullopt;
  }
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

std::optional<desc::Node> finish_mesh(const Source& source, desc::Mesh mesh) {
  if (!validate(source, mesh)) return std::nullopt;
  return desc::mesh_node(std::make_shared<const desc::Mesh>(std::move(mesh)));
}

std::optional<desc::Node> triangle_mesh(const Source& source) {
  const ParameterList& p = source.parameters;
  desc::Mesh mesh;
  mesh.positions = p.get_points("P");
  mesh.indices = indices_of(source);
  mesh.normals = p.get_normals("N");
  mesh.tangents = p.get_vectors("S");
  if (const Parameter* signs = p.find(own_word("handedness"), ParameterKind::Integer)) {
    for (const int sign : signs->integers) {
      mesh.handedness.push_back(static_cast<std::int8_t>(std::clamp(sign, -1, 1)));
    }
  }
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

std::optional<desc::Node> ply_mesh(const Source& source, MeshLoader& meshes) {
  const std::optional<std::string> name = source.parameters.get_string("filename");
  if (!name || name->empty()) throw SceneError(source.where, "a plymesh needs \"string filename\"");
  return desc::mesh_node(meshes.request(source.where, *name));
}

std::optional<desc::Node> loop_subdivision(const Source& source) {
  const ParameterList& p = source.parameters;
  desc::Mesh control;
  const int levels = p.get_int("levels", p.get_int("nlevels", 3));
  control.positions = p.get_points("P");
  control.indices = indices_of(source);
  p.accept({"scheme"});
  if (control.positions.empty()) throw SceneError(source.where, "a loopsubdiv needs \"point P\"");
  if (control.indices.empty())
    throw SceneError(source.where, "a loopsubdiv needs \"integer indices\"");
  const auto faces = static_cast<double>(control.indices.size());
  if (levels < 0 || faces * std::pow(4.0, levels) > kMostTriangles) {
    throw SceneError(source.where,
                     "\"levels\" of " + std::to_string(levels) + " make no sense here");
  }
  if (!validate(source, control)) return std::nullopt;
  return desc::shape_node(
      "subdivision",
      {{"levels", levels}, {"control", std::make_shared<const desc::Mesh>(std::move(control))}});
}

/// pbrt's height field: z over the unit square, two triangles per cell.
std::optional<desc::Node> height_field(const Source& source) {
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

/// The ends of a quadric along z, within a sphere.
std::array<float, 2> ends_of(const desc::Node& node) {
  const float radius = node.number("radius");
  const auto end = [&](const char* name, float whole) {
    const float* given = std::get_if<float>(&node.get(name));
    if (given == nullptr) return whole;
    return node.is("sphere") ? std::clamp(*given, -std::abs(radius), std::abs(radius)) : *given;
  };
  const float a = end("z_min", -radius);
  const float b = end("z_max", radius);
  return {std::min(a, b), std::max(a, b)};
}
float lower_end(const desc::Node& node) { return ends_of(node)[0]; }
float higher_end(const desc::Node& node) { return ends_of(node)[1]; }

/// Why nothing can be seen of a quadric; null if something can.
const char* flaw_of(const desc::Node& node) {
  const bool has_radius = !node.has("radius") || node.number("radius") > 0.F;
  if (node.is("hyperboloid")) return node.get("p1") == node.get("p2") ? "p1 equals p2" : nullptr;
  if (node.is("cone")) {
    const bool has_height = node.number("height") > 0.F;
    return has_radius && has_height ? nullptr : "radius or height is not positive";
  }
  if (node.is("paraboloid") && !(has_radius && higher_end(node) > 0.F)) {
    return "radius or zmax is not positive";
  }
  if (!has_radius) return "the radius is not positive";
  if (node.is("disk")) {
    const float inner = node.number("inner_radius");
    const bool is_inside = inner >= 0.F && inner < node.number("radius");
    return is_inside ? nullptr : "the inner radius is not between 0 and the radius";
  }
  return node.has("z_min") && !(lower_end(node) < higher_end(node)) ? "zmin equals zmax" : nullptr;
}

/// Shape options of pbrt-v4 that are not supported.
void report_unsupported(const Source& source, const std::string& type) {
  const ParameterList& p = source.parameters;
  if (type != "plymesh") return;
  const bool is_displaced = p.get_string("displacement").has_value() ||
                            p.find("displacement", ParameterKind::Texture) != nullptr;
  p.accept({"edgelength", "displacement.uvscale", "uvscale", "displacement.scale"});
  if (is_displaced) {
    source.context.warnings.add(kDisplaced, source.where,
                                "\"displacement\" of meshes is not supported: left as it is");
  }
}

/// A shape that numbers describe.
std::optional<desc::Node> plain_shape(const Source& source, TextureTable& textures,
                                      const desc::Model& model, const ModelName* names) {
  const TextureParameters lookup(source.context, textures, source.parameters);
  desc::Node node = NodeReader(source.where, lookup).read(model, names);
  if (const char* flaw = flaw_of(node)) return source.skip(flaw);
  return node;
}

}  // namespace

std::optional<desc::Node> make_shape(Context& context, MeshLoader& meshes, TextureTable& textures,
                                     const SourceLocation& where, const std::string& type,
                                     const ParameterList& parameters) {
  const Source source{context, where, parameters};
  const bool is_v4 = context.is_v4();
  if (is_v4) report_unsupported(source, type);
  if (type == "bilinearmesh" && is_v4) {
    return finish_mesh(source, read_bilinear_mesh(where, parameters).mesh);
  }
  if (type == "trianglemesh") return triangle_mesh(source);
  if (type == "plymesh") return ply_mesh(source, meshes);
  if (type == "loopsubdiv") return loop_subdivision(source);
  if (type == "curve") return make_curve(context, where, parameters);
  if (type == "heightfield" && !is_v4) return height_field(source);
  if (type == "nurbs" && !is_v4) return source.skip("nurbs are not supported");
  const std::vector<ModelName>& table = shape_names(context.choice.dialect);
  if (const desc::Model* model = model_of_type(desc::ModelKind::Shape, table, type)) {
    return plain_shape(source, textures, *model, find_theirs(table, type));
  }
  std::vector<std::string> types = types_of(desc::ModelKind::Shape, table);
  const std::vector<std::string>& others = is_v4 ? kOtherTypesOfV4 : kOtherTypes;
  types.insert(types.end(), others.begin(), others.end());
  report_unknown(context, where, "shape", type, types, kUnknownShape, "It is left out");
  return std::nullopt;
}

}  // namespace ajar::pbrt
