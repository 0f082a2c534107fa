#pragma once
#include "scene/bsdf/lobe.h"

namespace ajar {

/// Thin glossy coat of Disney's model: distribution GTR1, Schlick's Fresnel term with R0 = 0.04,
/// masking with the fixed α = 0.25, a quarter of the strength: f = D F G / (16 |cos θ_o| |cos
/// θ_i|). Source: Burley 2012, appendix B; 2015.
struct DisneyClearcoat {
  static constexpr bool kSpecular = false;
  float alpha = 0.1F;         ///< in (0, 1)
  bool is_one_sided = false;  ///< black from behind
  /// f = D F G / 4, as Mitsuba 3 has it: brighter along the normal, darker at grazing angles.
  bool flat = false;

  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode) const {
    if (transmission || !same_hemisphere(wo, wi) || is_hidden(wo)) return {};
    const HalfVector half = half_vector(wo, wi);
    return value(wo, wi, half.h, half.cosine);
  }

  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3&,
                                   TransportMode) const {
    if (is_hidden(wo)) return std::nullopt;
    const bool front = wo.z > 0.F;
    const Vec3 o = front ? wo : -wo;
    const float alpha2 = alpha * alpha;
    // 1 − cos² θ_h, written so that it keeps its digits for narrow lobes.
    const float sin2 = std::clamp(
        alpha2 * std::expm1(-std::log(alpha2) * u.direction.x) / (1.F - alpha2), 0.F, 1.F);
    const float sin_h = std::sqrt(sin2);
    const float phi = 2.F * kPi * u.direction.y;
    const Vec3 h(sin_h * std::cos(phi), sin_h * std::sin(phi), std::sqrt(1.F - sin2));
    const float cos_d = dot(o, h);
    const Vec3 i = h * (2.F * cos_d) - o;
    if (i.z < kGrazing || !(cos_d > 0.F)) return std::nullopt;
    const LobeValue v = value(o, i, h, cos_d);
    if (!(v.pdf > 0.F)) return std::nullopt;
    return LobeSample{front ? i : -i, v.value / v.pdf, v.pdf, v.reverse_pdf};
  }

  LobeInverse inverse(const Vec3& wo, const Vec3& wi, float, const Vec3&) const {
    if (!same_hemisphere(wo, wi) || is_hidden(wo)) return {};
    const bool front = wo.z > 0.F;
    const HalfVector half = half_vector(front ? wo : -wo, front ? wi : -wi);
    const Vec3& h = half.h;
    const float alpha2 = alpha * alpha;
    const float sin2 = h.x * h.x + h.y * h.y;
    const float x = std::log1p(sin2 * (1.F - alpha2) / alpha2) / -std::log(alpha2);
    return {{std::clamp(x, 0.F, kOneMinusEpsilon), warp::turn_of({h.x, h.y})},
            value(wo, wi, h, half.cosine).pdf};
  }

  Spectrum albedo(const Vec3& wo) const {
    if (is_hidden(wo)) return {};
    const float cosine = std::abs(wo.z);
    const float geometry = flat ? 4.F * cosine * cosine : 1.F;
    return Spectrum(0.25F * geometry * (0.04F + 0.96F * schlick_weight(cosine)));
  }

 private:
  bool is_hidden(const Vec3& wo) const { return is_one_sided && wo.z < 0.F; }
  /// Smith's G1 for GGX over 2 |cos θ|.
  static float masking(float cosine) {
    constexpr float kAlpha2 = 0.25F * 0.25F;
    return 1.F / (cosine + std::sqrt(kAlpha2 + (1.F - kAlpha2) * cosine * cosine));
  }
  LobeValue value(const Vec3& wo, const Vec3& wi, const Vec3& h, float cos_d) const {
    const float alpha2 = alpha * alpha;
    const float cos_h = std::abs(h.z);
    // 1 + (α² − 1) cos² θ_h, without its cancellation.
    const float spread = alpha2 * cos_h * cos_h + h.x * h.x + h.y * h.y;
    const float density = (alpha2 - 1.F) / (kPi * std::log(alpha2) * spread);
    const float fresnel = 0.04F + 0.96F * schlick_weight(cos_d);
    const float pdf = density * cos_h / (4.F * cos_d);
    const float cos_o = std::abs(wo.z);
    const float cos_i = std::abs(wi.z);
    const float strength = flat ? cos_o * cos_i : 0.25F;
    return {Spectrum(strength * density * fresnel * masking(cos_o) * masking(cos_i) * cos_i), pdf,
            pdf};
  }
};

}  // namespace ajar
