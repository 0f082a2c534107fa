#pragma once
#include "scene/bsdf/fresnel.h"
#include "scene/bsdf/microfacet.h"

namespace ajar {

/// Diffuse base under a glossy coat that takes more and more of the light toward grazing angles.
/// Source: Ashikhmin & Shirley 2000, with a microfacet distribution as in pbrt-v3, section 8.5.
struct FresnelBlend {
  static constexpr bool kSpecular = false;
  Microfacets facets;
  PackedSpectrum diffuse;   ///< reflectance of the base
  PackedSpectrum specular;  ///< reflectance of the coat at normal incidence

  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode) const {
    if (transmission) return {};
    const float cos_o = std::abs(wo.z);
    const float cos_i = std::abs(wi.z);
    const Spectrum rs = specular.unpack();
    const float p_o = coat_probability(cos_o);
    const float p_i = coat_probability(cos_i);
    const float base = (28.F / (23.F * kPi)) * base_falloff(cos_o) * base_falloff(cos_i) * cos_i;
    LobeValue v{diffuse.unpack() * (Spectrum(1.F) - rs) * base, (1.F - p_o) * cosine_pdf(wi),
                (1.F - p_i) * cosine_pdf(wo)};
    if (!same_hemisphere(wo, wi)) return v;
    const auto [h, cos_h] = half_vector(wo, wi);
    const float density = 0.25F * facets.density(h);
    v.value += schlick(rs, cos_h) * (density * cos_i / (cos_h * std::max(cos_o, cos_i)));
    v.pdf += p_o * density / facets.projected_area(wo);
    v.reverse_pdf += p_i * density / facets.projected_area(wi);
    return v;
  }

  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3& ng,
                                   TransportMode mode) const {
    Vec3 wi;
    if (u.lobe < coat_probability(std::abs(wo.z))) {
      const bool front = wo.z > 0.F;
      const Vec3 o = front ? wo : -wo;
      const Vec3 h = facets.sample_visible(o, u.direction);
      const Vec3 i = h * (2.F * dot(o, h)) - o;
      if (i.z < kGrazing) return std::nullopt;
      wi = front ? i : -i;
    } else {
      wi = cosine_around(u.direction, ng);
    }
    const LobeValue v = evaluate(wo, wi, false, mode);
    if (!(v.pdf > 0.F)) return std::nullopt;
    return LobeSample{wi, v.value / v.pdf, v.pdf, v.reverse_pdf};
  }

  LobeInverse inverse(const Vec3& wo, const Vec3& wi, float u_lobe, const Vec3& ng) const {
    if (is_diffuse(wo, u_lobe)) return cosine_inverse(wi, ng);
    return mirror_inverse(facets, wo, wi);
  }
  UnitInterval choices(const Vec3& wo, const Vec3& wi, bool, float& u) const {
    const double coat = coat_probability(std::abs(wo.z));
    const double from_coat = coat * static_cast<double>(mirror_inverse(facets, wo, wi).pdf);
    const double from_base = (1.0 - coat) * static_cast<double>(cosine_pdf(wi));
    if (came_first(from_coat, from_base, u)) return {0.0, coat};
    return {coat, 1.0 - coat};
  }
  /// True if `u_lobe` selects the base.
  bool is_diffuse(const Vec3& wo, float u_lobe) const {
    return !(u_lobe < coat_probability(std::abs(wo.z)));
  }

  Spectrum albedo(const Vec3& wo) const {
    const Spectrum rs = specular.unpack();
    return schlick(rs, 0.95F * std::abs(wo.z)) +
           diffuse.unpack() * (Spectrum(1.F) - rs) * base_falloff(std::abs(wo.z));
  }

 private:
  static Spectrum schlick(const Spectrum& rs, float cosine) {
    return rs + schlick_weight(cosine) * (Spectrum(1.F) - rs);
  }
  static float base_falloff(float cosine) { return 1.F - pow5(1.F - 0.5F * cosine); }
  /// Share of the samples that the coat gets; never 0 or 1, so that no part is missed.
  float coat_probability(float cosine) const {
    const float rs = specular.average();
    const float coat = rs + schlick_weight(cosine) * (1.F - rs);
    const float base = diffuse.average() * (1.F - rs);
    // Both are 0 where nothing is reflected.
    return std::clamp(coat / std::max(coat + base, 1e-30F), 0.1F, 0.9F);
  }
};

}  // namespace ajar
