#pragma once
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "import/gltf/accessors.h"

namespace ajar::gltf {

/// What `COLOR_0` multiplies the base colour of a primitive with: a texture, or a colour.
struct VertexColors {
  desc::Value value;
  std::string name;  ///< tells them from others; of the image, if it is one
  bool is_image() const { return std::holds_alternative<desc::TextureRef>(value); }
};

/// The triangles of primitives. What is made of the same accessors is the same mesh.
class Meshes {
 public:
  Meshes(Context& context, Buffers& buffers) : context_(context), accessors_(context, buffers) {}

  /// The colours of the vertices of a primitive, if it has some: an image, or their mean if it is
  /// textured, as a mesh has one set of texture coordinates.
  const VertexColors* colors_of(const Element& primitive, bool is_textured);

  /// With the texture coordinates TEXCOORD_`uv_set`, v upwards, or those of the image `colors`, if
  /// it is one. Null, after a warning, if the primitive has no triangles. Raises SceneError if its
  /// data is damaged.
  desc::MeshPointer read(const Element& primitive, std::size_t uv_set, const VertexColors* colors);

 private:
  static constexpr std::size_t kNoAccessor = static_cast<std::size_t>(-1);
  /// POSITION, NORMAL, TEXCOORD, COLOR_0 if it is an image, indices, mode.
  using Key =
      std::tuple<std::size_t, std::size_t, std::size_t, std::size_t, std::size_t, std::uint64_t>;
  /// COLOR_0, indices, mode, whether it is textured.
  using ColorKey = std::tuple<std::size_t, std::size_t, std::uint64_t, bool>;

  std::size_t accessor_of(const std::optional<Element>& reference) const;
  desc::MeshPointer make(const Element& primitive, const Key& key, const VertexColors* image);
  std::optional<VertexColors> make_colors(const Element& attributes, bool is_textured);

  Context& context_;
  Accessors accessors_;
  std::map<Key, desc::MeshPointer> made_;
  std::map<ColorKey, std::optional<VertexColors>> colors_;
};

}  // namespace ajar::gltf
