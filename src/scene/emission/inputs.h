#pragma once
#include "scene/emission/registry.h"

namespace ajar {

/// The description of the light of one surface, with the surface.
class EmissionInputs {
 public:
  EmissionInputs(const desc::Emission& description, const SurfaceSampler& surface,
                 const TextureList& textures, const std::optional<BoundingSphere>& receivers)
      : description_(description), surface_(surface), textures_(textures), receivers_(receivers) {}

  const desc::Node& node() const { return description_.node; }
  const SourceLocation& where() const { return description_.where; }
  /// Outlives the light.
  const SurfaceSampler& surface() const { return surface_; }
  /// The sphere around everything that emits nothing, if it is known.
  const std::optional<BoundingSphere>& receivers() const { return receivers_; }
  /// The parameter of this name, a float or a colour.
  TextureSlot slot(std::string_view name) const {
    return texture_slot(node().get(name), textures_);
  }

 private:
  const desc::Emission& description_;
  const SurfaceSampler& surface_;
  const TextureList& textures_;
  const std::optional<BoundingSphere>& receivers_;
};

}  // namespace ajar
