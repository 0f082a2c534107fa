#pragma once
#include "scene/bsdf/cosine_sampled.h"

namespace ajar {

/// Rough diffuse reflection: Lambertian facets with Gaussian slopes. Source: Oren & Nayar 1994, the
/// "qualitative" model, in the form of pbrt-v3, section 8.4.1.
struct OrenNayar : CosineSampled<OrenNayar> {
  float a = 1.F;
  float b = 0.F;

  OrenNayar() = default;
  /// `sigma`: standard deviation of the facets' slope angle, radians.
  explicit OrenNayar(float sigma)
      : a(1.F - sigma * sigma / (2.F * (sigma * sigma + 0.33F))),
        b(0.45F * sigma * sigma / (sigma * sigma + 0.09F)) {}

  Spectrum albedo(const Vec3&) const { return Spectrum(a + 0.13F * b); }
  /// π f = A + B max(0, cos Δφ) sin α tan β. Since {α, β} are the larger and the smaller of the two
  /// angles, cos Δφ sin α tan β is the product of the tangential parts over the larger cosine.
  Spectrum times_pi(const Vec3& wo, const Vec3& wi) const {
    const float tangential = std::max(0.F, wo.x * wi.x + wo.y * wi.y);
    return Spectrum(a + b * tangential / std::max(std::abs(wo.z), std::abs(wi.z)));
  }
};

}  // namespace ajar
