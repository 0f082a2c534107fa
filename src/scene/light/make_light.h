#pragma once
#include "scene/light/light.h"

namespace ajar {

/// `make_light` for a scene with files inside of others, among which its maps may be.
std::unique_ptr<Light> make_light(const desc::Light& light, const BoundingSphere& bounds,
                                  Warnings& warnings, const desc::EmbeddedFiles& embedded);

}  // namespace ajar
