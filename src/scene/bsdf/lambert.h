#pragma once
#include "scene/bsdf/lobe.h"

namespace ajar {

/// Ideal diffuse reflection, f = 1/π.
struct Lambert {
  static constexpr bool kSpecular = false;
  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode) const {
    if (transmission) return {};
    return {Spectrum(cosine_pdf(wi)), cosine_pdf(wi), cosine_pdf(wo)};
  }
  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3& ng,
                                   TransportMode) const {
    const Vec3 wi = cosine_around(u.direction, ng);
    return LobeSample{wi, Spectrum(1.F), cosine_pdf(wi), cosine_pdf(wo)};
  }
  LobeInverse inverse(const Vec3&, const Vec3& wi, float, const Vec3& ng) const {
    return cosine_inverse(wi, ng);
  }
  bool is_diffuse(const Vec3&, float) const { return true; }
  Spectrum albedo(const Vec3&) const { return Spectrum(1.F); }
};

/// Ideal diffuse transmission, f = 1/π to the other side.
struct LambertTransmission {
  static constexpr bool kSpecular = false;
  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode) const {
    if (!transmission) return {};
    return {Spectrum(cosine_pdf(wi)), cosine_pdf(wi), cosine_pdf(wo)};
  }
  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3& ng,
                                   TransportMode) const {
    const Vec3 wi = cosine_around(u.direction, -ng);
    return LobeSample{wi, Spectrum(1.F), cosine_pdf(wi), cosine_pdf(wo), true};
  }
  LobeInverse inverse(const Vec3&, const Vec3& wi, float, const Vec3& ng) const {
    return cosine_inverse(wi, -ng);
  }
  bool is_diffuse(const Vec3&, float) const { return true; }
  Spectrum albedo(const Vec3&) const { return Spectrum(1.F); }
};

}  // namespace ajar
