#pragma once
#include <algorithm>

#include "scene/bsdf/cosine_sampled.h"
#include "scene/bsdf/under_layer.h"

/// Diffuse bases under a gloss, which receive the rest of the light, as in appendix B of glTF 2.0.
namespace ajar {

/// Mean of Schlick's weight at the half vector of diffuse light and a direction with this cosine:
/// ∫ (1 − cos θ_d)⁵ |cos θ_i| dω_i / π.
float mean_schlick_weight(float cosine);

/// Rough layer of a dielectric, as its base sees it.
struct Gloss {
  float eta = 1.5F;      ///< ≥ 1
  float alpha = 0.F;     ///< roughness of its facets
  float strength = 1.F;  ///< factor of its reflection

  /// Share of the light at this cosine that does not reach the base. In the appendix it is
  /// Fresnel's term of the half vector, whose mean is here; but no less than the gloss reflects,
  /// which is more where a smooth one is seen at grazing angles.
  float taken(float cosine) const;
  /// Mean of `taken` over a hemisphere, weighted by the cosine.
  float mean_taken() const;

  /// (1 − a(o)) (1 − a(i)) / (1 − ā), where a is the share taken by the gloss and ā its mean. So an
  /// even base reflects 1 − a(o) of its own reflection: base and gloss never reflect more than
  /// comes in, and are reciprocal. Source: Kelemen & Szirmay-Kalos 2001, "A microfacet based
  /// coupled specular-matte BRDF model".
  float left(const Vec3& wo, const Vec3& wi) const {
    return left_albedo(wo) * left_albedo(wi) / (1.F - mean_taken());
  }
  float left_albedo(const Vec3& w) const { return 1.F - taken(std::abs(w.z)); }
};

/// A lobe that spreads light evenly, under a gloss.
template <typename Base>
using UnderGloss = UnderLayer<Base, Gloss>;

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
