#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "scene/desc/scene_desc.h"

namespace ajar::gltf {

/// Factor of the base colour of a primitive by `COLOR_0`: a texture, or a colour.
struct VertexColors {
  desc::Value value;
  std::string name;  ///< unique name; of the image, if it is one
  bool is_image() const { return std::holds_alternative<desc::TextureRef>(value); }
};

/// All that a material says of the shapes that have it.
struct Surface {
  desc::MaterialId material = desc::kNone;
  desc::TextureId alpha = desc::kNone;
  std::optional<desc::Emission> emission;
  desc::MediumId inside = desc::kNone;
  /// The texture coordinates that its textures have; nothing if it has none.
  std::optional<std::size_t> uv_set;
  bool has_normal_map = false;
};

}  // namespace ajar::gltf
