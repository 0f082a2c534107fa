#pragma once
#include <memory>

#include "scene/direction_map.h"
#include "scene/light/light.h"
#include "scene/light/map.h"

/// The light models, one file each; `make_light` chooses among them.
namespace ajar {

/// Where a light stands and how it is turned.
struct LightPlacement {
  Vec3 position;
  DirectionMap directions;
};

std::unique_ptr<Light> make_point_light(const desc::PointLight& light, const LightPlacement& at);
std::unique_ptr<Light> make_spot_light(const desc::SpotLight& light, const LightPlacement& at);
std::unique_ptr<Light> make_distant_light(const desc::DistantLight& light, const LightPlacement& at,
                                          const BoundingSphere& bounds);
std::unique_ptr<Light> make_constant_environment(const Spectrum& radiance,
                                                 const BoundingSphere& bounds);
/// `scale` multiplies the map.
std::unique_ptr<Light> make_environment_map(const Spectrum& scale, Map map,
                                            const LightPlacement& at, const BoundingSphere& bounds);
std::unique_ptr<Light> make_goniometric_light(const desc::GoniometricLight& light, Map map,
                                              const LightPlacement& at);
std::unique_ptr<Light> make_projection_light(const desc::ProjectionLight& light, Map map,
                                             const LightPlacement& at);

}  // namespace ajar
