#pragma once
#include "scene/bsdf/specular.h"

namespace ajar {

/// Smooth boundary between two dielectrics: mirror reflection or refraction, chosen in proportion
/// to what they carry. `reflect` and `transmit` tint the two.
struct SmoothDielectric {
  static constexpr bool kSpecular = true;
  PackedSpectrum reflect;
  PackedSpectrum transmit;
  float eta = 1.5F;  ///< index behind the surface over that in front

  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3&,
                                   TransportMode mode) const {
    const float relative = wo.z > 0.F ? eta : 1.F / eta;
    const DielectricBoundary boundary = fresnel_dielectric(std::abs(wo.z), relative);
    const float reflected = boundary.reflectance * reflect.average();
    const float transmitted = (1.F - boundary.reflectance) * transmit.average();
    if (!(reflected + transmitted > 0.F)) return std::nullopt;
    const float p = reflected / (reflected + transmitted);
    // By the symmetry of Fresnel's equations the reverse event has the same probabilities.
    if (u.lobe < p) {
      return LobeSample{{-wo.x, -wo.y, wo.z}, reflect.unpack() * (boundary.reflectance / p), p, p};
    }
    const float q = 1.F - p;
    if (!(q > 0.F) || boundary.cos_t < kGrazing) return std::nullopt;
    const float scale = mode == TransportMode::Radiance ? 1.F / (relative * relative) : 1.F;
    return LobeSample{refract_at_plane(wo, relative, boundary.cos_t),
                      transmit.unpack() * ((1.F - boundary.reflectance) * scale / q),
                      q,
                      q,
                      true,
                      relative};
  }
  Spectrum albedo(const Vec3& wo) const {
    const Spectrum f = DielectricFresnel{eta}(std::abs(wo.z), wo.z > 0.F);
    return reflect.unpack() * f + transmit.unpack() * (Spectrum(1.F) - f);
  }
};

/// Pane without thickness: two parallel boundaries with all reflections between them. Transmits
/// straight on, and radiance is not scaled, because the same medium is on both sides.
/// The series R + T R T + T R³ T + … sums to 2R/(1+R) for T = 1 − R.
struct ThinDielectric {
  static constexpr bool kSpecular = true;
  PackedSpectrum reflect;
  PackedSpectrum transmit;
  float eta = 1.5F;  ///< index of the pane over that around it

  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3&,
                                   TransportMode) const {
    const float reflectance = pane_reflectance(wo);
    const float reflected = reflectance * reflect.average();
    const float transmitted = (1.F - reflectance) * transmit.average();
    if (!(reflected + transmitted > 0.F)) return std::nullopt;
    const float p = reflected / (reflected + transmitted);
    if (u.lobe < p) {
      return LobeSample{{-wo.x, -wo.y, wo.z}, reflect.unpack() * (reflectance / p), p, p};
    }
    const float q = 1.F - p;
    if (!(q > 0.F)) return std::nullopt;
    return LobeSample{-wo, transmit.unpack() * ((1.F - reflectance) / q), q, q, true};
  }
  Spectrum albedo(const Vec3& wo) const {
    const float reflectance = pane_reflectance(wo);
    return reflect.unpack() * reflectance + transmit.unpack() * (1.F - reflectance);
  }

 private:
  float pane_reflectance(const Vec3& wo) const {
    const float r = fresnel_dielectric(std::abs(wo.z), eta).reflectance;
    return 2.F * r / (1.F + r);
  }
};

}  // namespace ajar
