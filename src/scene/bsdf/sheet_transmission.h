#pragma once
#include "scene/bsdf/microfacet_reflection.h"

namespace ajar {

/// Transmittance of the boundary of a sheet, equal from both sides.
struct SheetFresnel {
  float eta = 1.5F;  ///< index of the sheet over that around it
  Spectrum operator()(float cos_i, bool /*front*/) const {
    return Spectrum(1.F - fresnel_dielectric(cos_i, eta).reflectance);
  }
};

/// Transmission through a rough sheet without thickness, which blurs light and does not bend it:
/// the reflection of mirror facets, mirrored to the other side, times 1 − F. Source: Burley 2015.
struct SheetTransmission {
  static constexpr bool kSpecular = false;
  Microfacets facets;
  float eta = 1.5F;

  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode mode) const {
    if (!transmission) return {};
    return reflection().evaluate(wo, mirrored(wi), false, mode);
  }
  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3& ng,
                                   TransportMode mode) const {
    std::optional<LobeSample> s = reflection().sample(wo, u, ng, mode);
    if (s) {
      s->wi = mirrored(s->wi);
      s->transmission = true;
    }
    return s;
  }
  LobeInverse inverse(const Vec3& wo, const Vec3& wi, float u_lobe, const Vec3& ng) const {
    return reflection().inverse(wo, mirrored(wi), u_lobe, ng);
  }
  /// Where the mean surface reflects totally, some facets still transmit.
  Spectrum albedo(const Vec3& wo) const { return clamp(reflection().albedo(wo), 0.05F, 1.F); }

 private:
  static Vec3 mirrored(const Vec3& w) { return {w.x, w.y, -w.z}; }
  MicrofacetReflection<SheetFresnel> reflection() const { return {facets, {eta}}; }
};

}  // namespace ajar
