#pragma once
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "import/gltf/accessors.h"
#include "import/gltf/surface.h"

namespace ajar::gltf {

/// The triangles of primitives. What is made of the same accessors is the same mesh.
class Meshes {
 public:
  Meshes(Context& context, Buffers& buffers) : context_(context), accessors_(context, buffers) {}

  /// The colours of the vertices of a primitive, if it has some: an image, or their mean if it is
  /// textured, as a mesh has one set of texture coordinates.
  const VertexColors* colors_of(const Element& primitive, bool is_textured);

  /// With the texture coordinates of `surface`, v upwards, or those of the image `colors`, if it is
  /// one, and with tangents if there is a normal map. Null, after a warning, if the primitive has
  /// no triangles. Raises SceneError if its data is damaged.
  desc::MeshPointer read(const Element& primitive, const Surface& surface,
                         const VertexColors* colors);

 private:
  static constexpr std::size_t kNoAccessor = static_cast<std::size_t>(-1);
  /// Numbers of accessors, and the mode.
  struct Key {
    std::size_t positions, normals, tangents, uvs, colors, indices;
    std::uint64_t mode;
    auto operator<=>(const Key&) const = default;
  };
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
