#pragma once
#include <map>
#include <tuple>
#include <vector>

#include "import/gltf/accessors.h"

namespace ajar::gltf {

/// The triangles of primitives. What is made of the same accessors is the same mesh.
class Meshes {
 public:
  Meshes(Context& context, Buffers& buffers) : context_(context), accessors_(context, buffers) {}

  /// With the texture coordinates TEXCOORD_`uv_set`, v upwards. Null, after a warning, if the
  /// primitive has no triangles. Raises SceneError if its data is damaged.
  desc::MeshPointer read(const Element& primitive, std::size_t uv_set);

 private:
  static constexpr std::size_t kNoAccessor = static_cast<std::size_t>(-1);
  /// POSITION, NORMAL, TEXCOORD, indices, mode.
  using Key = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t, std::uint64_t>;

  std::size_t accessor_of(const std::optional<Element>& reference) const;
  desc::MeshPointer make(const Element& primitive, const Key& key);
  void warn_of_attributes(const Element& primitive, const Element& attributes);

  Context& context_;
  Accessors accessors_;
  std::map<Key, desc::MeshPointer> made_;
};

}  // namespace ajar::gltf
