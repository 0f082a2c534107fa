#pragma once
#include "core/frame.h"
#include "core/pdf.h"
#include "core/warp.h"

/// Henyey–Greenstein phase function. `wo` and `wi` are unit vectors that point away from the
/// scattering point; g > 0 scatters forward. It is its own density. Source: Henyey & Greenstein
/// 1941.
namespace ajar::phase {

inline float henyey_greenstein(float g, const Vec3& wo, const Vec3& wi) {
  const float denominator = 1.F + g * g + 2.F * g * dot(wo, wi);
  return 0.25F * kInvPi * (1.F - g * g) / (denominator * std::sqrt(std::max(denominator, 1e-12F)));
}

inline Vec3 sample_henyey_greenstein(float g, const Vec3& wo, const Vec2& u) {
  float cos_theta = 1.F - 2.F * u.x;
  if (std::abs(g) > 1e-3F) {
    const float ratio = (1.F - g * g) / (1.F + g - 2.F * g * u.x);
    cos_theta = -(1.F + g * g - ratio * ratio) / (2.F * g);
  }
  cos_theta = std::clamp(cos_theta, -1.F, 1.F);
  const float sin_theta = std::sqrt(std::max(0.F, 1.F - cos_theta * cos_theta));
  const float phi = 2.F * kPi * u.y;
  return Frame::around(wo).to_world(
      {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta});
}

/// The numbers by which `sample_henyey_greenstein` gives `wi`.
inline Vec2 invert_henyey_greenstein(float g, const Vec3& wo, const Vec3& wi) {
  const Vec3 local = Frame::around(wo).to_local(wi);
  float u = 0.5F * (1.F - local.z);
  if (std::abs(g) > 1e-3F) {
    // ratio² is the denominator's square in the density.
    const float ratio = std::sqrt(std::max(1.F + g * g + 2.F * g * local.z, 1e-12F));
    u = (1.F + g - (1.F - g * g) / ratio) / (2.F * g);
  }
  return {std::clamp(u, 0.F, kOneMinusEpsilon), warp::turn_of({local.x, local.y})};
}

}  // namespace ajar::phase
