#pragma once
#include <algorithm>

#include "scene/bsdf/cosine_sampled.h"

/// Diffuse bases that get what a gloss above them leaves, as in appendix B of glTF 2.0.
namespace ajar {

/// Mean of Schlick's weight at the half vector of diffuse light and a direction with this cosine:
/// ∫ (1 − cos θ_d)⁵ |cos θ_i| dω_i / π.
float mean_schlick_weight(float cosine);

/// Rough layer of a dielectric, as its base sees it.
struct Gloss {
  float eta = 1.5F;      ///< ≥ 1
  float alpha = 0.F;     ///< roughness of its facets
  float strength = 1.F;  ///< factor of what it reflects

  /// Share of the light at this cosine that never comes to the base. In the appendix it is
  /// Fresnel's term of the half vector, whose mean is here; but no less than the gloss reflects,
  /// which is more where a smooth one is seen at grazing angles.
  float taken(float cosine) const;
  /// Mean of `taken` over a hemisphere, weighted by the cosine.
  float mean_taken() const;
};

/// A lobe that spreads light evenly, weakened by (1 − a(o)) (1 − a(i)) / (1 − ā), where a is what
/// the gloss has taken and ā its mean. So the base reflects 1 − a(o) of what it does alone: lobe
/// and gloss never reflect more than comes in, and are reciprocal. Source: Kelemen & Szirmay-Kalos
/// 2001, "A microfacet based coupled specular-matte BRDF model".
template <typename Base>
struct UnderGloss {
  static constexpr bool kSpecular = false;
  Base base;
  Gloss gloss;

  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode mode) const {
    LobeValue v = base.evaluate(wo, wi, transmission, mode);
    v.value *= left(wo, wi);
    return v;
  }
  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3& ng,
                                   TransportMode mode) const {
    std::optional<LobeSample> s = base.sample(wo, u, ng, mode);
    if (s) s->weight *= left(wo, s->wi);
    return s;
  }
  LobeInverse inverse(const Vec3& wo, const Vec3& wi, float u_lobe, const Vec3& ng) const {
    return base.inverse(wo, wi, u_lobe, ng);
  }
  bool is_diffuse(const Vec3&, float) const { return true; }
  Spectrum albedo(const Vec3& wo) const { return base.albedo(wo) * left(wo); }

 private:
  float left(const Vec3& w) const { return 1.F - gloss.taken(std::abs(w.z)); }
  float left(const Vec3& wo, const Vec3& wi) const {
    return left(wo) * left(wi) / (1.F - gloss.mean_taken());
  }
};

/// Diffuse base under Disney's sheen, which is light that it does not get. Source of the latter:
/// KHR_materials_sheen, with the larger share of the two directions.
struct SheenOverLambert : CosineSampled<SheenOverLambert> {
  PackedSpectrum color;
  PackedSpectrum sheen;

  SheenOverLambert() = default;
  SheenOverLambert(const Spectrum& its_color, const Spectrum& its_sheen)
      : color(its_color), sheen(its_sheen) {}

  Spectrum albedo(const Vec3& wo) const {
    const float weight = mean_schlick_weight(std::abs(wo.z));
    return sheen.unpack() * (kPi * weight) + below(weight);
  }
  /// π f(wo, wi).
  Spectrum times_pi(const Vec3& wo, const Vec3& wi) const {
    const Spectrum above = sheen.unpack();
    if (above.is_black()) return color.unpack();
    const float cosine = std::min(std::abs(wo.z), std::abs(wi.z));
    const float cos_d = std::sqrt(std::clamp(0.5F * (1.F + dot(wo, wi)), 0.F, 1.F));
    return above * (kPi * schlick_weight(cos_d)) + below(mean_schlick_weight(cosine));
  }

 private:
  /// The base where the sheen has this mean weight.
  Spectrum below(float weight) const {
    return color.unpack() * std::max(0.F, 1.F - kPi * sheen.unpack().max() * weight);
  }
};

}  // namespace ajar
