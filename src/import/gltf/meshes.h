#pragma once
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "import/gltf/accessors.h"
#include "import/gltf/pose.h"
#include "import/gltf/surface.h"

namespace ajar::gltf {

/// The triangles of primitives. Equal accessors give one mesh.
class Meshes {
 public:
  Meshes(Context& context, Accessors& accessors) : context_(context), accessors_(accessors) {}

  /// The colours of the vertices of a primitive, if it has some: an image, or their mean if it is
  /// textured, as a mesh has one set of texture coordinates.
  const VertexColors* colors_of(const Element& primitive, const Pose& pose, bool is_textured);

  /// With the texture coordinates of `surface`, v upwards, or those of the image `colors`, if it is
  /// one, with tangents if there is a normal map, and in its pose. Null, after a warning, if the
  /// primitive has no triangles. Raises SceneError if its data is damaged.
  desc::MeshPointer read(const Element& primitive, const Pose& pose, const Surface& surface,
                         const VertexColors* colors);

 private:
  static constexpr std::size_t kNoAccessor = static_cast<std::size_t>(-1);
  /// Numbers of accessors, the mode, and, if there is a pose, the key of it and the primitive.
  struct Key {
    std::size_t positions, normals, tangents, uvs, colors, indices;
    std::uint64_t mode;
    std::string pose;
    auto operator<=>(const Key&) const = default;
  };
  /// COLOR_0, positions, indices, mode, pose, whether it is textured.
  using ColorKey =
      std::tuple<std::size_t, std::size_t, std::size_t, std::uint64_t, std::string, bool>;

  std::size_t accessor_of(const std::optional<Element>& reference) const;
  desc::MeshPointer make(const Element& primitive, const Pose& pose, const Key& key,
                         const VertexColors* image);
  std::optional<VertexColors> make_colors(const Element& attributes, const std::string& pose,
                                          bool is_textured);

  Context& context_;
  Accessors& accessors_;
  std::map<Key, desc::MeshPointer> made_;
  std::map<ColorKey, std::optional<VertexColors>> colors_;
};

}  // namespace ajar::gltf
