#pragma once
#include "scene/bsdf/cosine_sampled.h"

namespace ajar {

/// Rough diffuse reflection: Lambertian facets with Gaussian slopes, with the light that they send
/// to each other. Source: Oren & Nayar 1994, section 4.4 (the functional approximation).
struct FullOrenNayar : CosineSampled<FullOrenNayar> {
  PackedSpectrum reflectance;
  float variance = 0.F;  ///< variance of the facets' slope angle, radians²

  FullOrenNayar() = default;
  /// `sigma`: standard deviation of the facets' slope angle, radians.
  FullOrenNayar(const Spectrum& color, float sigma) : reflectance(color), variance(sigma * sigma) {}

  /// Approximate albedo for light from the viewer's side.
  Spectrum albedo(const Vec3&) const {
    const Spectrum color = reflectance.unpack();
    return color * (1.F - 0.45F * variance / (variance + 0.33F)) +
           color * color * (0.15F * variance / (variance + 0.13F));
  }
  /// π f = ρ (C₁ + cos Δφ C₂ tan β + (1 − |cos Δφ|) C₃ tan ((α + β) / 2)) + ρ² 0.17 σ² / (σ² +
  /// 0.13) (1 − cos Δφ (2β/π)²), with α and β the larger and the smaller of the two angles.
  Spectrum times_pi(const Vec3& wo, const Vec3& wi) const {
    const float angle_o = std::acos(std::min(std::abs(wo.z), 1.F));
    const float angle_i = std::acos(std::min(std::abs(wi.z), 1.F));
    const float alpha = std::max(angle_o, angle_i);
    const float beta = std::min(angle_o, angle_i);
    const float across = std::sqrt((wo.x * wo.x + wo.y * wo.y) * (wi.x * wi.x + wi.y * wi.y));
    const float cos_turn =
        across > 0.F ? std::clamp((wo.x * wi.x + wo.y * wi.y) / across, -1.F, 1.F) : 0.F;
    const float smaller = 2.F * beta * kInvPi;
    const float c1 = 1.F - 0.5F * variance / (variance + 0.33F);
    const float narrow = variance / (variance + 0.09F);
    const float sine = std::sin(alpha) - (cos_turn < 0.F ? smaller * smaller * smaller : 0.F);
    const float both = 4.F * alpha * beta * kInvPi * kInvPi;
    const float single = c1 + cos_turn * 0.45F * narrow * sine * std::tan(beta) +
                         (1.F - std::abs(cos_turn)) * 0.125F * narrow * both * both *
                             std::tan(0.5F * (alpha + beta));
    const float twice =
        0.17F * variance / (variance + 0.13F) * (1.F - cos_turn * smaller * smaller);
    const Spectrum color = reflectance.unpack();
    return color * std::max(single, 0.F) + color * color * twice;
  }
};

}  // namespace ajar
