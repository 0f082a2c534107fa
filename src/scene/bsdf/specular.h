#pragma once
#include "scene/bsdf/fresnel.h"
#include "scene/bsdf/lobe.h"

namespace ajar {

/// Perfect mirror that reflects everything.
struct Mirror {
  static constexpr bool kSpecular = true;
  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms&, const Vec3&,
                                   TransportMode) const {
    return LobeSample{{-wo.x, -wo.y, wo.z}, Spectrum(1.F), 1.F, 1.F};
  }
  Spectrum albedo(const Vec3&) const { return Spectrum(1.F); }
};

/// Mirror reflection at a dielectric boundary; refracted light is lost.
struct SpecularReflection {
  static constexpr bool kSpecular = true;
  float eta = 1.5F;  ///< index behind the surface over that in front
  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms&, const Vec3&,
                                   TransportMode) const {
    return LobeSample{{-wo.x, -wo.y, wo.z}, albedo(wo), 1.F, 1.F};
  }
  Spectrum albedo(const Vec3& wo) const {
    return DielectricFresnel{eta}(std::abs(wo.z), wo.z > 0.F);
  }
};

/// Direction of `wo` refracted at the plane z = 0, given the relative index of refraction and the
/// cosine of the refracted angle.
inline Vec3 refract_at_plane(const Vec3& wo, float eta, float cos_t) {
  return {-wo.x / eta, -wo.y / eta, wo.z > 0.F ? -cos_t : cos_t};
}

/// Refraction at a dielectric boundary; reflected light is lost.
struct SpecularTransmission {
  static constexpr bool kSpecular = true;
  float eta = 1.5F;  ///< index behind the surface over that in front
  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms&, const Vec3&,
                                   TransportMode mode) const {
    const float relative = wo.z > 0.F ? eta : 1.F / eta;
    const DielectricBoundary boundary = fresnel_dielectric(std::abs(wo.z), relative);
    if (boundary.reflectance == 1.F) return std::nullopt;
    const float scale = mode == TransportMode::Radiance ? 1.F / (relative * relative) : 1.F;
    return LobeSample{refract_at_plane(wo, relative, boundary.cos_t),
                      Spectrum((1.F - boundary.reflectance) * scale),
                      1.F,
                      1.F,
                      true,
                      relative};
  }
  Spectrum albedo(const Vec3& wo) const {
    return Spectrum(1.F) - DielectricFresnel{eta}(std::abs(wo.z), wo.z > 0.F);
  }
};

/// Straight on, as if there were no surface: partial opacity.
struct PassThrough {
  static constexpr bool kSpecular = true;
  bool uncounted = false;  ///< see Bsdf::is_uncounted
  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms&, const Vec3&,
                                   TransportMode) const {
    return LobeSample{-wo, Spectrum(1.F), 1.F, 1.F, true};
  }
  Spectrum albedo(const Vec3&) const { return Spectrum(1.F); }
};

}  // namespace ajar
