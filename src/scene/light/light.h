#pragma once
#include <memory>
#include <vector>

#include "core/warnings.h"
#include "scene/desc/scene_desc.h"
#include "scene/endpoint.h"
#include "scene/light/light_bounds.h"
#include "scene/shape/surface_sampler.h"
#include "scene/texture/texture.h"

namespace ajar {

class Medium;

/// A light source. `emitted` is its radiance; a light on a surface is hit by rays through the shape
/// it is on, a light at infinity by rays that leave the scene.
class Light : public Endpoint {
 public:
  /// Emitted power per lane, W, approximately; of lights at infinity the power that crosses the
  /// scene's bounding sphere. Used to choose among lights: > 0 in some lane for every light that
  /// emits at all.
  virtual Spectrum power() const = 0;
  /// Where it is and where it shines; empty for lights at infinity.
  virtual std::optional<LightBounds> bounds() const { return std::nullopt; }
  /// Number of primitives of its surface: points of it have `SurfacePoint::primitive` below that.
  virtual std::uint32_t primitives() const { return 1; }
  /// For lights at infinity that are not discrete: the vertex that a ray leaving the scene along
  /// unit `w` runs into.
  virtual EndpointPoint at_direction(const Vec3& w) const;
  /// For discrete lights: the vertex that all their light comes from.
  virtual EndpointPoint only_point() const;

  std::uint32_t index = 0;  ///< position in the scene's list
  /// Medium that rays leaving the light start in (points, infinity).
  const Medium* medium = nullptr;
};

using LightList = std::vector<std::unique_ptr<Light>>;

/// Sphere around everything that is finite in a scene: lights at infinity emit through it.
struct BoundingSphere {
  Vec3 center{0.F, 0.F, 0.F};
  float radius = 1.F;
};

/// The lights that are not on surfaces. Maps that cannot be read become magenta and a warning; a
/// transform that cannot be inverted counts as no rotation and is a warning. Raises SceneError for
/// lights too far away. `index` and `medium` are for the caller to fill in.
std::unique_ptr<Light> make_light(const desc::Light& light, const BoundingSphere& bounds,
                                  Warnings& warnings);

}  // namespace ajar
