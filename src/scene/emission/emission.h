#pragma once
#include <memory>

#include "scene/light/light.h"

namespace ajar {

/// The light of a surface. The sampler must outlive it. Raises SceneError for emission of no model
/// and for light that is not finite. `index` and `medium` are for the caller to fill in.
std::unique_ptr<Light> make_surface_light(const desc::Emission& emission,
                                          const SurfaceSampler& surface,
                                          const TextureList& textures);

}  // namespace ajar
