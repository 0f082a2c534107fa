#include "core/sphere_mapping.h"

#include <algorithm>
#include <cmath>

#include "core/unit_interval.h"
#include "core/warp.h"

namespace ajar {
namespace {

/// From [−1, 1] into [0, 1).
float half_of(float x) { return std::clamp(0.5F * (x + 1.F), 0.F, kOneMinusEpsilon); }

}  // namespace

Vec2 lat_long::to_uv(const Vec3& w) {
  // atan2 instead of acos: near the poles acos keeps only half of the digits.
  const float theta = std::atan2(std::sqrt(w.x * w.x + w.y * w.y), w.z);
  float u = std::atan2(w.y, w.x) * (0.5F * kInvPi);
  if (u < 0.F) u += 1.F;
  return {std::min(u, kOneMinusEpsilon), std::min(theta * kInvPi, kOneMinusEpsilon)};
}

Vec3 lat_long::to_direction(const Vec2& uv) {
  const float theta = kPi * uv.y;
  const float phi = 2.F * kPi * uv.x;
  const float sine = std::sin(theta);
  return {sine * std::cos(phi), sine * std::sin(phi), std::cos(theta)};
}

Vec2 equal_area::to_uv(const Vec3& w) {
  const float x = std::abs(w.x);
  const float y = std::abs(w.y);
  const float size = length(w);
  // √(1 − |z|), which keeps its digits near the poles.
  const float r = std::sqrt((x * x + y * y) / (size * (size + std::abs(w.z))));
  const float turn = std::atan2(y, x) * (2.F * kInvPi);  // angle within a quadrant
  float v = turn * r;
  float u = r - v;
  if (w.z < 0.F) {
    // Folded out across the diagonal.
    const float outer_u = 1.F - v;
    v = 1.F - u;
    u = outer_u;
  }
  return {half_of(std::copysign(u, w.x)), half_of(std::copysign(v, w.y))};
}

Vec3 equal_area::to_direction(const Vec2& uv) {
  const float u = 2.F * uv.x - 1.F;
  const float v = 2.F * uv.y - 1.F;
  const float up = std::abs(u);
  const float vp = std::abs(v);
  const float signed_distance = 1.F - (up + vp);  // to the diagonal, which is the horizon
  const float d = std::abs(signed_distance);
  const float r = 1.F - d;
  const float phi = (r == 0.F ? 1.F : (vp - up) / r + 1.F) * (kPi / 4.F);
  const float z = std::copysign(1.F - r * r, signed_distance);
  const float sine = r * std::sqrt(std::max(0.F, 2.F - r * r));
  return {std::copysign(std::cos(phi), u) * sine, std::copysign(std::sin(phi), v) * sine, z};
}

}  // namespace ajar
