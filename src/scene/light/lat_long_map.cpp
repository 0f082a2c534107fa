#include "scene/light/lat_long_map.h"

#include <utility>

namespace ajar {

namespace {
/// d(uv)/dω = 1 / (2π² sin θ).
Pdf<SolidAngle> per_solid_angle(float pdf_uv, float sine) {
  if (!(sine > 1e-7F)) return Pdf<SolidAngle>(0.F);
  return Pdf<SolidAngle>(pdf_uv / (2.F * kPi * kPi * sine));
}

float sin_theta(const Vec2& uv) { return std::sin(kPi * uv.y); }
}  // namespace

LatLongMap::LatLongMap(Map map)
    : map_(std::move(map)),
      distribution_(make_map_distribution(map_, sin_theta)),
      integral_(integrate_map(map_, sin_theta) * (2.F * kPi * kPi)) {}

Vec2 LatLongMap::to_uv(const Vec3& w) {
  // atan2 instead of acos: near the poles acos keeps only half of the digits.
  const float theta = std::atan2(std::sqrt(w.x * w.x + w.y * w.y), w.z);
  float u = std::atan2(w.y, w.x) * (0.5F * kInvPi);
  if (u < 0.F) u += 1.F;
  return {std::min(u, kOneMinusEpsilon), std::min(theta * kInvPi, kOneMinusEpsilon)};
}

Vec3 LatLongMap::to_direction(const Vec2& uv) {
  const float theta = kPi * uv.y;
  const float phi = 2.F * kPi * uv.x;
  const float sin_theta = std::sin(theta);
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), std::cos(theta)};
}

LatLongMap::Sample LatLongMap::sample(const Vec2& u) const {
  const Distribution2D::Sample chosen = distribution_.sample(u);
  return {chosen.uv, to_direction(chosen.uv), per_solid_angle(chosen.pdf, sin_theta(chosen.uv))};
}

Pdf<SolidAngle> LatLongMap::pdf(const Vec2& uv) const {
  return per_solid_angle(distribution_.pdf(uv), sin_theta(uv));
}

}  // namespace ajar
