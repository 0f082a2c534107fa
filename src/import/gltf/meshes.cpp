#include "import/gltf/meshes.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "import/common/vertex_colors.h"
#include "import/mesh/validate_mesh.h"
#include "scene/desc/models.h"

namespace ajar::gltf {
namespace {

using Triangle = Imath::Vec3<unsigned>;

constexpr WarningKind kNoTriangles{Effect::Geometry,
                                   "primitives are points or lines and are left out"};
constexpr WarningKind kColorsBesideTexture{
    Effect::Surface, "primitives have colours of vertices beside a texture: their mean is used"};
constexpr WarningKind kOtherCount{Effect::Surface,
                                  "primitives have not as many colours as vertices: ignored"};
constexpr WarningKind kNoUvs{Effect::Surface,
                             "primitives have textures, but no texture coordinates for them"};
constexpr WarningKind kPlainColors{
    Effect::Slight, "primitives have colours that are integers without \"normalized\""};
constexpr WarningKind kVertexAlpha{Effect::Surface,
                                   "primitives have vertices that are partly clear: opaque"};

/// Values of `mode` (glTF 2.0, section 5.24.4).
constexpr std::uint64_t kTriangles = 4;
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

/// Key of a pose at a primitive; empty if there is none.
std::string key_of(const Pose& pose, const Element& primitive) {
  return pose.name.empty() ? "" : primitive.pointer() + pose.name;
}

/// True if the bitangent agrees with the texture coordinates, as it mostly does: then it need not
/// be stored.
bool agrees_with_uvs(const desc::Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  if (mesh.uvs.size() != vertices || mesh.normals.size() != vertices ||
      mesh.tangents.size() != vertices || mesh.handedness.size() != vertices) {
    return false;
  }
  return std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](const Triangle& t) {
    if (std::max({t.x, t.y, t.z}) >= vertices) return true;  // an error, soon
    const Vec2 d1 = mesh.uvs[t.y] - mesh.uvs[t.x];
    const Vec2 d2 = mesh.uvs[t.z] - mesh.uvs[t.x];
    const Vec3 e1 = mesh.positions[t.y] - mesh.positions[t.x];
    const Vec3 e2 = mesh.positions[t.z] - mesh.positions[t.x];
    const Vec3 up = (e2 * d1.x - e1 * d2.x) * (d1.x * d2.y - d1.y * d2.x < 0.F ? -1.F : 1.F);
    return std::ranges::all_of(std::array{t.x, t.y, t.z}, [&](unsigned i) {
      const float side = dot(cross(mesh.normals[i], mesh.tangents[i]), up);
      return side * static_cast<float>(mesh.handedness[i]) > 0.F;
    });
  });
}

std::string uv_name(std::size_t set) { return "TEXCOORD_" + std::to_string(set); }

}  // namespace

std::size_t Meshes::accessor_of(const std::optional<Element>& reference) const {
  return reference ? accessors_.index_of(*reference) : kNoAccessor;
}

const VertexColors* Meshes::colors_of(const Element& primitive, const Pose& pose,
                                      bool is_textured) {
  const Element attributes = primitive.at("attributes");
  const std::optional<Element> reference = attributes.find("COLOR_0");
  if (!reference) return nullptr;
  const ColorKey key{accessors_.index_of(*reference),
                     accessors_.index_of(attributes.at("POSITION")),
                     accessor_of(primitive.find("indices")),
                     primitive.value_or<std::uint64_t>("mode", kTriangles),
                     key_of(pose, primitive),
                     is_textured};
  const auto [place, is_new] = colors_.try_emplace(key);
  if (is_new) place->second = make_colors(attributes, pose.name, is_textured);
  return place->second ? &*place->second : nullptr;
}

std::optional<VertexColors> Meshes::make_colors(const Element& attributes, const std::string& pose,
                                                bool is_textured) {
  const Element reference = attributes.at("COLOR_0");
  const std::size_t vertices = accessors_.count(accessors_.index_of(attributes.at("POSITION")));
  const std::vector<Imath::V4f> colors = accessors_.read_colors(accessors_.index_of(reference));
  if (colors.size() != vertices || vertices == 0) {
    context_.warnings.add(kOtherCount, reference.where(),
                          "there are " + std::to_string(colors.size()) + " colours for " +
                              std::to_string(vertices) + " vertices: ignored");
    return std::nullopt;
  }
  if (accessors_.are_plain_integers(accessors_.index_of(reference))) {
    context_.warnings.add(kPlainColors, reference.where(),
                          "these colours are integers without \"normalized\": taken as shares of "
                          "the largest");
  }
  Vec3d sum(0.0);
  for (const Imath::V4f& color : colors) sum += Vec3d(color.x, color.y, color.z);
  if (std::any_of(colors.begin(), colors.end(), [](const auto& color) { return color.w < 1.F; })) {
    context_.warnings.add(kVertexAlpha, reference.where(),
                          "the alpha of vertices is not supported: they are opaque");
  }
  VertexColors result{Vec3(sum / static_cast<double>(vertices)),
                      context_.path + reference.pointer() + pose + ".exr"};
  if (is_textured) {
    context_.warnings.add(kColorsBesideTexture, reference.where(),
                          "beside a texture, the mean of these colours is used");
    return result;
  }
  context_.scene.textures.push_back(
      {"", reference.where(),
       desc::texture_node("image", {{"file", result.name}, {"wrap", std::string("clamp")}})});
  result.value = desc::TextureRef{static_cast<desc::TextureId>(context_.scene.textures.size()) - 1};
  return result;
}

desc::MeshPointer Meshes::read(const Element& primitive, const Pose& pose, const Surface& surface,
                               const VertexColors* colors) {
  const std::uint64_t mode = primitive.value_or<std::uint64_t>("mode", kTriangles);
  if (mode > kFan) primitive.at("mode").fail("modes are from 0 to 6, not " + std::to_string(mode));
  if (mode < kTriangles) {
    context_.warnings.add(kNoTriangles, primitive.where(),
                          "this primitive is made of points or lines: left out");
    return nullptr;
  }
  const Element attributes = primitive.at("attributes");
  // Tangents of a surface without normals do not count (glTF 2.0, section 3.7.2.1).
  const bool has_tangents = surface.has_normal_map && attributes.has("NORMAL");
  const bool is_painted = colors != nullptr && colors->is_image();
  const Key key{.positions = accessor_of(attributes.at("POSITION")),
                .normals = accessor_of(attributes.find("NORMAL")),
                .tangents = has_tangents ? accessor_of(attributes.find("TANGENT")) : kNoAccessor,
                .uvs = accessor_of(attributes.find(uv_name(surface.uv_set.value_or(0)))),
                .colors = is_painted ? accessor_of(attributes.find("COLOR_0")) : kNoAccessor,
                .indices = accessor_of(primitive.find("indices")),
                .mode = mode,
                .pose = key_of(pose, primitive)};
  if (surface.uv_set && key.uvs == kNoAccessor) {
    context_.warnings.add(kNoUvs, primitive.where(),
                          "this primitive has no " + uv_name(*surface.uv_set) +
                              ", which the textures of its material use: each triangle shows half "
                              "of an image");
  }
  const auto [place, is_new] = made_.try_emplace(key);
  if (is_new) place->second = make(primitive, pose, key, colors);
  return place->second;
}

desc::MeshPointer Meshes::make(const Element& primitive, const Pose& pose, const Key& key,
                               const VertexColors* image) {
  auto mesh = std::make_shared<desc::Mesh>();
  mesh->positions = accessors_.read_vec3(key.positions);
  if (key.normals != kNoAccessor) mesh->normals = accessors_.read_vec3(key.normals);
  if (key.tangents != kNoAccessor) accessors_.read_tangents(key.tangents, *mesh);
  if (key.uvs != kNoAccessor) {
    mesh->uvs = accessors_.read_vec2(key.uvs);
    for (Vec2& uv : mesh->uvs) uv.y = 1.F - uv.y;
  }
  if (key.indices != kNoAccessor) {
    mesh->indices = assembled(accessors_.read_indices(key.indices), key.mode);
  } else {
    std::vector<unsigned> all(mesh->positions.size());
    std::iota(all.begin(), all.end(), 0U);
    mesh->indices = assembled(all, key.mode);
  }
  apply(pose, primitive, context_, accessors_, *mesh);
  if (agrees_with_uvs(*mesh)) mesh->handedness.clear();
  std::vector<Warning> remarks;
  validate_mesh(*mesh, primitive.where(), remarks);
  for (Warning& remark : remarks) context_.warnings.add(std::move(remark));
  if (mesh->indices.empty()) return nullptr;
  if (key.colors == kNoAccessor) return mesh;
  std::vector<Vec3> linear;
  for (const Imath::V4f& color : accessors_.read_colors(key.colors)) {
    linear.emplace_back(color.x, color.y, color.z);
  }
  PaintedMesh result = painted(*mesh, linear);
  context_.scene.embedded_files[image->name] =
      std::make_shared<const std::string>(std::move(result.image));
  return std::make_shared<const desc::Mesh>(std::move(result.mesh));
}

}  // namespace ajar::gltf
