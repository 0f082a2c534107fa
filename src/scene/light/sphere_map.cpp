#include "scene/light/sphere_map.h"

#include <utility>

namespace ajar {

SphereMap::SphereMap(Map map, const SphereProjection& projection)
    : map_(std::move(map)),
      projection_(projection),
      distribution_(make_map_distribution(map_, projection.solid_angle)),
      integral_(integrate_map(map_, projection.solid_angle)) {}

SphereMap::Sample SphereMap::sample(const Vec2& u) const {
  const Distribution2D::Sample chosen = distribution_.sample(u);
  return {chosen.uv, projection_.to_direction(chosen.uv), pdf(chosen.uv)};
}

Pdf<SolidAngle> SphereMap::pdf(const Vec2& uv) const {
  const float solid_angle = projection_.solid_angle(uv);
  // Next to a pole of a latitude map there is none.
  if (!(solid_angle > 2e-6F)) return Pdf<SolidAngle>(0.F);
  return Pdf<SolidAngle>(distribution_.pdf(uv) / solid_angle);
}

Spectrum SphereMap::irradiance() const {
  return integrate_map(map_, [&](const Vec2& uv) {
    return projection_.solid_angle(uv) * std::max(projection_.to_direction(uv).z, 0.F);
  });
}

}  // namespace ajar
