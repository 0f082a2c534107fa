#include "scene/texture/mapping.h"

#include <algorithm>

namespace ajar {

namespace {
struct PositionMapping {
  Vec3 p;
  Vec2 operator()(const desc::UvMapping& m) const { return {m.du, m.dv}; }
  Vec2 operator()(const desc::SphericalMapping& m) const {
    const Vec3 d = transform_point(m.world_to_texture, p);
    const float theta = std::atan2(std::hypot(d.x, d.y), d.z);
    const float phi = std::atan2(d.y, d.x);
    return {theta * kInvPi, (phi < 0.F ? phi + 2.F * kPi : phi) * (0.5F * kInvPi)};
  }
  Vec2 operator()(const desc::CylindricalMapping& m) const {
    const Vec3 d = transform_point(m.world_to_texture, p);
    const float size = length(d);
    return {(kPi + std::atan2(d.y, d.x)) * (0.5F * kInvPi), size > 0.F ? d.z / size : 0.F};
  }
  Vec2 operator()(const desc::PlanarMapping& m) const {
    return {m.ds + dot(p, m.vs), m.dt + dot(p, m.vt)};
  }
};
}  // namespace

Vec2 TextureMapping::map_position(const Vec3& p) const {
  return std::visit(PositionMapping{p}, mapping_);
}

int floor_to_int(float x) {
  constexpr float kLimit = 1e9F;
  return static_cast<int>(std::floor(std::isnan(x) ? 0.F : std::clamp(x, -kLimit, kLimit)));
}

}  // namespace ajar
