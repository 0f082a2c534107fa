#pragma once
#include <optional>

#include "scene/light/light.h"

namespace ajar {

/// Properties of the scene that lights need.
struct LightSurroundings {
  const BoundingSphere& bounds;
  /// The sphere around everything that emits nothing, if it is known.
  const std::optional<BoundingSphere>& receivers;
  /// Files inside of others, among which its maps may be.
  const desc::EmbeddedFiles& embedded;
};

/// `make_light` for a whole scene.
std::unique_ptr<Light> make_light(const desc::Light& light, const LightSurroundings& surroundings,
                                  Warnings& warnings);

}  // namespace ajar
