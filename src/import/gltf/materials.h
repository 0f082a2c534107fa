#pragma once
#include <map>
#include <optional>

#include "import/gltf/textures.h"

namespace ajar::gltf {

/// All that a material says of the shapes that have it.
struct Surface {
  desc::MaterialId material = desc::kNone;
  desc::TextureId alpha = desc::kNone;
  std::optional<desc::Emission> emission;
  desc::MediumId inside = desc::kNone;
  std::size_t uv_set = 0;
};

/// The materials of a file, each made when it is first asked for.
class Materials {
 public:
  Materials(Context& context, Buffers& buffers) : context_(context), images_(context, buffers) {}

  /// The material of a primitive.
  const Surface& of(const Element& primitive);

 private:
  Context& context_;
  Images images_;
  std::map<std::string, Surface> made_;  ///< by JSON pointer
  Surface none_;                         ///< of primitives that have no material
};

}  // namespace ajar::gltf
