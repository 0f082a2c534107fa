#pragma once
#include "scene/bsdf/specular.h"

namespace ajar {

/// Probability of reflection where reflection and transmission are chosen in proportion to their
/// energy; −1 if it is zero.
inline float reflection_probability(float reflectance, const PackedSpectrum& reflect,
                                    const PackedSpectrum& transmit) {
  const float reflected = reflectance * reflect.average();
  const float transmitted = (1.F - reflectance) * transmit.average();
  return reflected + transmitted > 0.F ? reflected / (reflected + transmitted) : -1.F;
}
/// The numbers that choose reflection, or those that choose transmission.
inline UnitInterval reflection_choices(float probability, bool transmission) {
  const double p = std::max(0.0, static_cast<double>(probability));
  return transmission ? UnitInterval{p, 1.0 - p} : UnitInterval{0.0, p};
}

/// Smooth boundary between two dielectrics: mirror reflection or refraction, chosen in proportion
/// to their energy. `reflect` and `transmit` tint the two.
struct SmoothDielectric {
  static constexpr bool kSpecular = true;
  PackedSpectrum reflect;
  PackedSpectrum transmit;
  float eta = 1.5F;  ///< index behind the surface over that in front

  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3&,
                                   TransportMode mode) const {
    const float relative = wo.z > 0.F ? eta : 1.F / eta;
    const DielectricBoundary boundary = fresnel_dielectric(std::abs(wo.z), relative);
    const float p = reflection_probability(boundary.reflectance, reflect, transmit);
    if (!(p >= 0.F)) return std::nullopt;
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
  UnitInterval choices(const Vec3& wo, const Vec3&, bool transmission, float&) const {
    const float relative = wo.z > 0.F ? eta : 1.F / eta;
    const float reflectance = fresnel_dielectric(std::abs(wo.z), relative).reflectance;
    return reflection_choices(reflection_probability(reflectance, reflect, transmit), transmission);
  }
  Spectrum albedo(const Vec3& wo) const {
    const Spectrum f = DielectricFresnel{eta}(std::abs(wo.z), wo.z > 0.F);
    return reflect.unpack() * f + transmit.unpack() * (Spectrum(1.F) - f);
  }
};

/// Pane without thickness: two parallel boundaries with all reflections between them. Transmits
/// straight on, and radiance is not scaled, because the same medium is on both sides.
/// The series R + T R T + T R³ T + … sums to 2R/(1+R) for T = 1 − R. Boundaries that are parallel
/// keep the polarisations apart, each with a series of its own; renderers often take that of the
/// mean.
struct ThinDielectric {
  static constexpr bool kSpecular = true;
  PackedSpectrum reflect;
  PackedSpectrum transmit;
  float eta = 1.5F;  ///< index of the pane over that around it
  bool polarised = false;
  bool along_normal = false;  ///< `transmit` is the transmittance along the normal, of an absorbing
                              ///< sheet
  bool uncounted = false;     ///< see Bsdf::is_uncounted

  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3&,
                                   TransportMode) const {
    const auto [reflectance, through] = crossing(wo);
    const float p = reflection_probability(reflectance, reflect, through);
    if (!(p >= 0.F)) return std::nullopt;
    if (u.lobe < p) {
      return LobeSample{{-wo.x, -wo.y, wo.z}, reflect.unpack() * (reflectance / p), p, p};
    }
    const float q = 1.F - p;
    if (!(q > 0.F)) return std::nullopt;
    return LobeSample{-wo, through.unpack() * ((1.F - reflectance) / q), q, q, true};
  }
  UnitInterval choices(const Vec3& wo, const Vec3&, bool transmission, float&) const {
    const auto [reflectance, through] = crossing(wo);
    return reflection_choices(reflection_probability(reflectance, reflect, through), transmission);
  }
  Spectrum albedo(const Vec3& wo) const {
    const auto [reflectance, through] = crossing(wo);
    return reflect.unpack() * reflectance + through.unpack() * (1.F - reflectance);
  }

 private:
  struct Crossing {
    float reflectance;
    PackedSpectrum transmit;
  };
  Crossing crossing(const Vec3& wo) const {
    const auto series = [](float r) { return 2.F * r / (1.F + r); };
    const float cos_i = std::abs(wo.z);
    const DielectricBoundary boundary = fresnel_dielectric(cos_i, eta);
    const float cos_t = boundary.cos_t;
    float reflectance = series(boundary.reflectance);
    if (!(cos_t > 0.F)) return {reflectance, transmit};
    if (polarised) {
      const auto [parallel, perpendicular] = fresnel_polarised(cos_i, cos_t, eta);
      reflectance = 0.5F * (series(parallel) + series(perpendicular));
    }
    if (!along_normal) return {reflectance, transmit};
    const auto slanted = [=](float t) { return t > 0.F ? std::pow(t, 1.F / cos_t) : 0.F; };
    return {reflectance, PackedSpectrum(map_lanes(transmit.unpack(), slanted))};
  }
};

}  // namespace ajar
