#pragma once
#include "scene/bsdf/fresnel.h"
#include "scene/bsdf/microfacet.h"

namespace ajar {

/// Reflection off rough mirrors whose facets reflect by `Fresnel`: f = F D G2 / (4 |cos θ_o| |cos
/// θ_i|). Source: Torrance & Sparrow 1967; Walter et al. 2007, eq. 20.
template <typename Fresnel>
struct MicrofacetReflection {
  static constexpr bool kSpecular = false;
  Microfacets facets;
  Fresnel fresnel;

  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode) const {
    if (transmission || !same_hemisphere(wo, wi)) return {};
    const HalfVector half = half_vector(wo, wi);
    const float density = 0.25F * facets.density(half.h);
    const float cos_o = std::abs(wo.z);
    const float cos_i = std::abs(wi.z);
    const float area_o = facets.projected_area(wo);
    const float area_i = facets.projected_area(wi);
    const float shadowing = facets.shadowing_over_cosines(cos_o, area_o, cos_i, area_i);
    return {fresnel(half.cosine, wo.z > 0.F) * (density * shadowing * cos_i), density / area_o,
            density / area_i};
  }

  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3&,
                                   TransportMode) const {
    const bool front = wo.z > 0.F;
    const Vec3 o = front ? wo : -wo;
    const Vec3 h = facets.sample_visible(o, u.direction);
    const float cos_h = dot(o, h);
    const Vec3 i = h * (2.F * cos_h) - o;
    if (i.z < kGrazing || !(cos_h > 0.F)) return std::nullopt;
    const float area_o = facets.projected_area(o);
    const float area_i = facets.projected_area(i);
    const float density = 0.25F * facets.density(h);
    if (!(density > 0.F)) return std::nullopt;
    // D cancels: the weight is F · G2 / G1.
    const float shadowing = facets.shadowing_over_cosines(o.z, area_o, i.z, area_i);
    return LobeSample{front ? i : -i,
                      fresnel(std::min(1.F, cos_h), front) * (shadowing * area_o * i.z),
                      density / area_o, density / area_i};
  }

  LobeInverse inverse(const Vec3& wo, const Vec3& wi, float, const Vec3&) const {
    return mirror_inverse(facets, wo, wi);
  }

  /// At a slightly more grazing angle, as facets have: so it is not 0 where only the normal's term
  /// is.
  Spectrum albedo(const Vec3& wo) const { return fresnel(0.95F * std::abs(wo.z), wo.z > 0.F); }
};

/// Rough coat of a dielectric: the highlight of plastic. Refracted light is lost.
using DielectricReflection = MicrofacetReflection<DielectricFresnel>;

}  // namespace ajar
