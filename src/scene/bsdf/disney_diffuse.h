#pragma once
#include "scene/bsdf/cosine_sampled.h"

namespace ajar {

/// All reflecting diffuse-like parts of Disney's model in one lobe: diffuse with Fresnel falloff,
/// flattened "fake subsurface", retro-reflection of rough surfaces, and sheen.
/// Sources: Burley 2012, 2015.
struct DisneyDiffuse : CosineSampled<DisneyDiffuse> {
  PackedSpectrum color;  ///< times the share of the plain diffuse part
  PackedSpectrum sheen;
  float fake_subsurface = 0.F;  ///< share of the flattened part, over that of the plain one
  float retro = 1.F;            ///< share of the retro-reflection, over that of the plain part
  float roughness = 0.5F;
  bool is_one_sided = false;  ///< black from behind

  /// Shares of the three parts that have the colour.
  struct Shares {
    float plain = 1.F;
    float flat = 0.F;
    float retro = 1.F;
  };

  DisneyDiffuse() = default;
  DisneyDiffuse(const PackedSpectrum& its_color, const PackedSpectrum& its_sheen,
                const Shares& shares, float its_roughness = 0.5F, bool one_sided = false)
      : sheen(its_sheen), roughness(its_roughness), is_one_sided(one_sided) {
    // Three shares and a colour have one number more than the lobe has room for.
    constexpr float kLeast = 1e-6F;
    const float plain = std::max(shares.plain, kLeast);
    color = PackedSpectrum(its_color.unpack() * plain);
    fake_subsurface = shares.flat / plain;
    retro = shares.retro / plain;
  }

  Spectrum albedo(const Vec3& wo) const {
    if (is_one_sided && wo.z < 0.F) return {};
    const float grazing = schlick_weight(std::abs(wo.z));
    const float base = (1.F + fake_subsurface) * (1.F - 0.5F * grazing) +
                       retro * roughness * (0.05F + 0.95F * grazing);
    // ∫ (1 − cos θ_d)⁵ cos θ_i dω_i is about 0.04 for a view along the normal, 0.8 at grazing.
    return color.unpack() * base + sheen.unpack() * (0.04F + 0.76F * grazing);
  }
  /// π f(wo, wi).
  Spectrum times_pi(const Vec3& wo, const Vec3& wi) const {
    if (is_one_sided && (wo.z < 0.F || wi.z < 0.F)) return {};
    const float cos_o = std::abs(wo.z);
    const float cos_i = std::abs(wi.z);
    const float fo = schlick_weight(cos_o);
    const float fi = schlick_weight(cos_i);
    // θ_d is half the angle between the two directions.
    const float cos2_d = std::clamp(0.5F * (1.F + dot(wo, wi)), 0.F, 1.F);
    const float plain = (1.F - 0.5F * fo) * (1.F - 0.5F * fi);
    const float rr = 2.F * roughness * cos2_d;
    float base = plain + retro * (rr * (fo + fi + fo * fi * (rr - 1.F)));
    if (fake_subsurface > 0.F) {
      const float fss90 = cos2_d * roughness;
      const float fss = (1.F + fo * (fss90 - 1.F)) * (1.F + fi * (fss90 - 1.F));
      base += fake_subsurface * 1.25F * (fss * (1.F / (cos_o + cos_i) - 0.5F) + 0.5F);
    }
    return color.unpack() * base + sheen.unpack() * (kPi * schlick_weight(std::sqrt(cos2_d)));
  }
};

}  // namespace ajar
