#pragma once
#include "scene/bsdf/cosine_sampled.h"

namespace ajar {

/// All reflecting diffuse-like parts of Disney's model in one lobe: diffuse with Fresnel falloff,
/// flattened "fake subsurface", retro-reflection of rough surfaces, and sheen.
/// Sources: Burley 2012, 2015; combined as pbrt-v3 does.
struct DisneyDiffuse : CosineSampled<DisneyDiffuse> {
  PackedSpectrum color;
  PackedSpectrum sheen;
  float diffuse = 1.F;          ///< share of the plain diffuse part
  float fake_subsurface = 0.F;  ///< share of the flattened part
  float roughness = 0.5F;

  DisneyDiffuse() = default;
  DisneyDiffuse(const PackedSpectrum& its_color, const PackedSpectrum& its_sheen, float plain = 1.F,
                float flat = 0.F, float its_roughness = 0.5F)
      : color(its_color),
        sheen(its_sheen),
        diffuse(plain),
        fake_subsurface(flat),
        roughness(its_roughness) {}

  Spectrum albedo(const Vec3& wo) const {
    const float grazing = schlick_weight(std::abs(wo.z));
    const float base = (diffuse + fake_subsurface) * (1.F - 0.5F * grazing) +
                       roughness * (0.05F + 0.95F * grazing);
    // ∫ (1 − cos θ_d)⁵ cos θ_i dω_i is about 0.04 for a view along the normal, 0.8 at grazing.
    return color.unpack() * base + sheen.unpack() * (0.04F + 0.76F * grazing);
  }
  /// π f(wo, wi).
  Spectrum times_pi(const Vec3& wo, const Vec3& wi) const {
    const float cos_o = std::abs(wo.z);
    const float cos_i = std::abs(wi.z);
    const float fo = schlick_weight(cos_o);
    const float fi = schlick_weight(cos_i);
    // θ_d is half the angle between the two directions.
    const float cos2_d = std::clamp(0.5F * (1.F + dot(wo, wi)), 0.F, 1.F);
    const float plain = (1.F - 0.5F * fo) * (1.F - 0.5F * fi);
    const float rr = 2.F * roughness * cos2_d;
    const float retro = rr * (fo + fi + fo * fi * (rr - 1.F));
    float base = diffuse * plain + retro;
    if (fake_subsurface > 0.F) {
      const float fss90 = cos2_d * roughness;
      const float fss = (1.F + fo * (fss90 - 1.F)) * (1.F + fi * (fss90 - 1.F));
      base += fake_subsurface * 1.25F * (fss * (1.F / (cos_o + cos_i) - 0.5F) + 0.5F);
    }
    return color.unpack() * base + sheen.unpack() * (kPi * schlick_weight(std::sqrt(cos2_d)));
  }
};

}  // namespace ajar
