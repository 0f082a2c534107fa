#pragma once
#include <memory>

#include "scene/light/inputs.h"
#include "scene/light/sphere_map.h"

/// Common parts of several models of lights.
namespace ajar {

std::unique_ptr<Light> make_point_light(const Spectrum& intensity, const LightPlacement& at,
                                        const Aim& aim);
std::unique_ptr<Light> make_constant_environment(const Spectrum& radiance,
                                                 const BoundingSphere& bounds);
/// `scale` multiplies the map.
std::unique_ptr<Light> make_environment_map(const Spectrum& scale, SphereMap map,
                                            const LightPlacement& at, const BoundingSphere& bounds);

}  // namespace ajar
