#include "import/gltf/meshes.h"

#include <numeric>

#include "import/mesh/validate_mesh.h"

namespace ajar::gltf {
namespace {

using Triangle = Imath::Vec3<unsigned>;

constexpr WarningKind kNoTriangles{Effect::Geometry,
                                   "primitives are points or lines and are left out"};
constexpr WarningKind kColors{Effect::Surface, "primitives have colours of vertices: ignored"};
constexpr WarningKind kMorphs{Effect::Geometry,
                              "primitives have morph targets, and are shown without them"};

/// Values of `mode` (glTF 2.0, section 5.24.4).
constexpr std::uint64_t kTriangles = 4;
constexpr std::uint64_t kStrip = 5;
constexpr std::uint64_t kFan = 6;

/// The triangles of a mode (glTF 2.0, section 3.7.2.1), counterclockwise seen from the front.
std::vector<Triangle> assembled(const std::vector<unsigned>& indices, std::uint64_t mode) {
  std::vector<Triangle> triangles;
  const std::size_t n = indices.size();
  if (mode == kTriangles) {
    triangles.reserve(n / 3);
    for (std::size_t i = 0; i + 2 < n; i += 3) {
      triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
    }
    return triangles;
  }
  triangles.reserve(n);
  for (std::size_t i = 0; i + 2 < n; ++i) {
    if (mode == kFan) {
      triangles.emplace_back(indices[i + 1], indices[i + 2], indices[0]);
    } else {
      triangles.emplace_back(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]);
    }
  }
  return triangles;
}

std::string uv_name(std::size_t set) { return "TEXCOORD_" + std::to_string(set); }

}  // namespace

std::size_t Meshes::accessor_of(const std::optional<Element>& reference) const {
  return reference ? accessors_.index_of(*reference) : kNoAccessor;
}

desc::MeshPointer Meshes::read(const Element& primitive, std::size_t uv_set) {
  const std::uint64_t mode = primitive.whole_or("mode", kTriangles);
  if (mode > kFan) primitive.at("mode").fail("modes are from 0 to 6, not " + std::to_string(mode));
  if (mode < kTriangles) {
    context_.warnings.add(kNoTriangles, primitive.where(),
                          "this primitive is made of points or lines: left out");
    return nullptr;
  }
  const Element attributes = primitive.at("attributes");
  const Key key{accessor_of(attributes.at("POSITION")), accessor_of(attributes.find("NORMAL")),
                accessor_of(attributes.find(uv_name(uv_set))),
                accessor_of(primitive.find("indices")), mode};
  const auto [place, is_new] = made_.try_emplace(key);
  if (is_new) {
    place->second = make(primitive, key);
    warn_of_attributes(primitive, attributes);
  }
  return place->second;
}

desc::MeshPointer Meshes::make(const Element& primitive, const Key& key) {
  const auto [positions, normals, uvs, indices, mode] = key;
  auto mesh = std::make_shared<desc::Mesh>();
  mesh->positions = accessors_.read_vec3(positions);
  if (normals != kNoAccessor) mesh->normals = accessors_.read_vec3(normals);
  if (uvs != kNoAccessor) {
    mesh->uvs = accessors_.read_vec2(uvs);
    for (Vec2& uv : mesh->uvs) uv.y = 1.F - uv.y;
  }
  if (indices != kNoAccessor) {
    mesh->indices = assembled(accessors_.read_indices(indices), mode);
  } else {
    std::vector<unsigned> all(mesh->positions.size());
    std::iota(all.begin(), all.end(), 0U);
    mesh->indices = assembled(all, mode);
  }
  std::vector<Warning> remarks;
  validate_mesh(*mesh, primitive.where(), remarks);
  for (Warning& remark : remarks) context_.warnings.add(std::move(remark));
  return mesh->indices.empty() ? nullptr : mesh;
}

void Meshes::warn_of_attributes(const Element& primitive, const Element& attributes) {
  if (attributes.has("COLOR_0")) {
    context_.warnings.add(kColors, primitive.where(), "colours of vertices are ignored");
  }
  if (primitive.has("targets")) {
    context_.warnings.add(kMorphs, primitive.where(), "morph targets are not applied");
  }
}

}  // namespace ajar::gltf
