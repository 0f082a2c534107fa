#pragma once
#include "scene/bsdf/fresnel.h"

namespace ajar {

/// Smooth mirror that reflects by `Fresnel`; the rest is lost.
template <typename Fresnel>
struct FresnelMirror {
  static constexpr bool kSpecular = true;
  Fresnel fresnel;

  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms&, const Vec3&,
                                   TransportMode) const {
    return LobeSample{{-wo.x, -wo.y, wo.z}, albedo(wo), 1.F, 1.F};
  }
  Spectrum albedo(const Vec3& wo) const { return fresnel(std::abs(wo.z), wo.z > 0.F); }
};

/// Polished metal.
using SmoothConductor = FresnelMirror<ConductorFresnel>;

}  // namespace ajar
