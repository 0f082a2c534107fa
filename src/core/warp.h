#pragma once
#include <algorithm>

#include "core/vector.h"

/// Maps from the unit square (uniform numbers in [0,1)²) to simple domains, with their densities.
/// Source: Shirley & Chiu 1997; Pharr et al., "Physically Based Rendering", section A.5.
namespace ajar::warp {

/// Uniform on the unit disk (concentric map). Density 1/π with respect to area.
inline Vec2 uniform_disk(const Vec2& u) {
  const float a = 2.F * u.x - 1.F;
  const float b = 2.F * u.y - 1.F;
  if (a == 0.F && b == 0.F) return {0.F, 0.F};
  float r = b;
  float phi = kPi * 0.5F - kPi * 0.25F * (a / b);
  if (std::abs(a) > std::abs(b)) {
    r = a;
    phi = kPi * 0.25F * (b / a);
  }
  return {r * std::cos(phi), r * std::sin(phi)};
}

/// The inverse of `uniform_disk`, within [0, 1)²; `d` may lie outside the disk by rounding.
inline Vec2 uniform_disk_inverse(const Vec2& d) {
  const float r = std::sqrt(d.x * d.x + d.y * d.y);
  Vec2 ab(0.F, 0.F);
  if (std::abs(d.x) > std::abs(d.y)) {
    ab.x = std::copysign(r, d.x);
    ab.y = ab.x * std::atan(d.y / d.x) * (4.F * kInvPi);
  } else if (d.y != 0.F) {
    ab.y = std::copysign(r, d.y);
    ab.x = ab.y * std::atan(d.x / d.y) * (4.F * kInvPi);
  }
  const auto unit = [](float v) { return std::clamp(0.5F * v + 0.5F, 0.F, kOneMinusEpsilon); };
  return {unit(ab.x), unit(ab.y)};
}

/// The angle from the x axis to `d`, as a share of a full turn: what φ = 2π u was made of.
inline float turn_of(const Vec2& d) {
  const float turn = std::atan2(d.y, d.x) * (0.5F * kInvPi);
  return std::clamp(turn < 0.F ? turn + 1.F : turn, 0.F, kOneMinusEpsilon);
}

/// Cosine-weighted on the hemisphere z ≥ 0. Density cos θ / π, solid angle.
inline Vec3 cosine_hemisphere(const Vec2& u) {
  const Vec2 d = uniform_disk(u);
  return {d.x, d.y, std::sqrt(std::max(0.F, 1.F - d.x * d.x - d.y * d.y))};
}
inline float cosine_hemisphere_pdf(float cos_theta) { return std::max(0.F, cos_theta) * kInvPi; }

/// Uniform on the sphere. Density 1/(4π), solid angle.
inline Vec3 uniform_sphere(const Vec2& u) {
  const float z = 1.F - 2.F * u.x;
  const float r = std::sqrt(std::max(0.F, 1.F - z * z));
  const float phi = 2.F * kPi * u.y;
  return {r * std::cos(phi), r * std::sin(phi), z};
}
/// The inverse of `uniform_sphere`, of a unit vector.
inline Vec2 uniform_sphere_inverse(const Vec3& w) {
  return {std::clamp(0.5F * (1.F - w.z), 0.F, kOneMinusEpsilon), turn_of({w.x, w.y})};
}
inline constexpr float kUniformSpherePdf = 0.25F * kInvPi;

/// Uniform within the cone around +z whose half angle has cosine 1 − `one_minus_cos_max` (passed
/// this way because narrow cones lose all precision in the cosine itself).
inline Vec3 uniform_cone(const Vec2& u, float one_minus_cos_max) {
  const float one_minus_cos = u.x * one_minus_cos_max;
  const float cos_theta = 1.F - one_minus_cos;
  const float sin_theta = std::sqrt(std::max(0.F, one_minus_cos * (2.F - one_minus_cos)));
  const float phi = 2.F * kPi * u.y;
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}
inline float uniform_cone_pdf(float one_minus_cos_max) {
  return 1.F / (2.F * kPi * one_minus_cos_max);
}

/// Uniform barycentric coordinates (b1, b2) of a triangle; density 1/area.
/// Source: Heitz 2019, "A low-distortion map between triangle and square".
inline Vec2 uniform_triangle(Vec2 u) {
  if (u.y > u.x) {
    u.x *= 0.5F;
    u.y -= u.x;
  } else {
    u.y *= 0.5F;
    u.x -= u.y;
  }
  return u;
}

/// The inverse of `uniform_triangle`; `b` may lie outside by rounding.
inline Vec2 uniform_triangle_inverse(const Vec2& b) {
  const float less = 2.F * std::min(b.x, b.y);
  const Vec2 u = b.y > b.x ? Vec2(less, b.x + b.y) : Vec2(b.x + b.y, less);
  const auto unit = [](float v) { return std::clamp(v, 0.F, kOneMinusEpsilon); };
  return {unit(u.x), unit(u.y)};
}

}  // namespace ajar::warp
