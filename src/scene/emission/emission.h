#pragma once
#include <memory>
#include <optional>

#include "scene/light/light.h"

namespace ajar {

/// The light of a surface. The sampler must outlive it. It is aimed at `receivers`, the sphere
/// around everything that emits nothing, where that is known. Raises SceneError for emission of no
/// model and for light that is not finite. `index` and `medium` are for the caller to fill in.
std::unique_ptr<Light> make_surface_light(const desc::Emission& emission,
                                          const SurfaceSampler& surface,
                                          const TextureList& textures,
                                          const std::optional<BoundingSphere>& receivers = {});

}  // namespace ajar
