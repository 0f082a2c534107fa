#pragma once
#include <map>
#include <optional>

#include "import/gltf/meshes.h"
#include "import/gltf/textures.h"

namespace ajar::gltf {

/// The materials of a file, each made when it is first asked for.
class Materials {
 public:
  Materials(Context& context, Buffers& buffers) : context_(context), images_(context, buffers) {}

  /// True if the material of a primitive refers to any texture that is read.
  bool has_textures(const Element& primitive) const;
  /// The material of a primitive, with `colors`, or null, on its base colour.
  const Surface& of(const Element& primitive, const VertexColors* colors);

 private:
  std::optional<Element> find(const Element& primitive) const;
  Surface make(const std::optional<Element>& material, const VertexColors* colors);

  Context& context_;
  Images images_;
  std::map<std::pair<std::string, std::string>, Surface> made_;  ///< by JSON pointer and colours
};

}  // namespace ajar::gltf
