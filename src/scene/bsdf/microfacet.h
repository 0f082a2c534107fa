#pragma once
#include <cstdint>

#include "scene/bsdf/lobe.h"

namespace ajar {

/// Distribution of microfacet normals, and their masking function.
enum class FacetModel : std::uint8_t {
  Ggx,                ///< Trowbridge–Reitz; height-correlated Smith masking
  GgxSeparable,       ///< GGX with G = G1·G1, as Disney's model has it
  Beckmann,           ///< Gaussian slopes; height-correlated Smith masking
  BeckmannSeparable,  ///< Beckmann with G = G1·G1
};

/// Distribution of microfacet normals with roughness `alpha_x`, `alpha_y` along the local x and y
/// axes. Directions may be on either side of the surface: D and masking are even functions.
/// Sources: Walter et al. 2007 (D, Λ); Heitz 2014 (height-correlated masking, visible normals).
class Microfacets {
 public:
  static constexpr float kMinAlpha = 1e-3F;
  static constexpr float kMaxAlpha = 10.F;

  Microfacets() = default;
  Microfacets(FacetModel model, float alpha_x, float alpha_y)
      : alpha_x_(clamp_alpha(alpha_x)), alpha_y_(clamp_alpha(alpha_y)), model_(model) {}

  float alpha_x() const { return alpha_x_; }
  float alpha_y() const { return alpha_y_; }
  FacetModel model() const { return model_; }

  /// D(h), 1/sr: ∫ D(h) |cos θ_h| dh over a hemisphere is 1.
  float density(const Vec3& h) const {
    const float x = h.x / alpha_x_;
    const float y = h.y / alpha_y_;
    const float z2 = h.z * h.z;
    const float area = kPi * alpha_x_ * alpha_y_;
    if (!is_beckmann()) {
      const float e = x * x + y * y + z2;
      return 1.F / (area * e * e);
    }
    const float z4 = z2 * z2;
    return z4 > 1e-30F ? std::exp(-(x * x + y * y) / z2) / (area * z4) : 0.F;
  }

  /// |cos θ| · (1 + Λ(w)) = |cos θ| / G1(w): the projected area of the facets that face `w`. Stays
  /// finite and positive at the horizon, unlike Λ itself.
  float projected_area(const Vec3& w) const {
    const float z = std::abs(w.z);
    const float x = alpha_x_ * w.x;
    const float y = alpha_y_ * w.y;
    const float s2 = x * x + y * y;
    if (!is_beckmann()) return 0.5F * (z + std::sqrt(z * z + s2));
    return beckmann_projected_area(z, std::sqrt(s2));
  }

  /// G2(wo, wi) / (|cos θ_o| |cos θ_i|), from the directions' |cosines| and projected areas.
  float shadowing_over_cosines(float cos_o, float area_o, float cos_i, float area_i) const {
    if (is_separable()) return 1.F / (area_o * area_i);
    return 1.F / (cos_i * area_o + cos_o * area_i - cos_o * cos_i);
  }

  /// The numbers by which `sample_visible` gives `h`.
  Vec2 invert_visible(const Vec3& w, const Vec3& h) const {
    const Vec3 stretched = normalize(Vec3(alpha_x_ * w.x, alpha_y_ * w.y, w.z));
    const Vec3 m = normalize(Vec3(h.x / alpha_x_, h.y / alpha_y_, h.z));
    return is_beckmann() ? beckmann_inverse(stretched, m) : ggx_inverse(stretched, m);
  }

  /// A facet normal (h.z ≥ 0) that is visible from `w` (w.z > 0), with density
  /// D(h) · max(0, w·h) / projected_area(w).
  Vec3 sample_visible(const Vec3& w, const Vec2& u) const {
    // Both models are stretched versions of their isotropic forms with α = 1.
    const Vec3 stretched = normalize(Vec3(alpha_x_ * w.x, alpha_y_ * w.y, w.z));
    const Vec3 h = is_beckmann() ? beckmann_visible(stretched, u) : ggx_visible(stretched, u);
    return normalize(Vec3(alpha_x_ * h.x, alpha_y_ * h.y, std::max(h.z, 1e-12F)));
  }

 private:
  bool is_beckmann() const {
    return model_ == FacetModel::Beckmann || model_ == FacetModel::BeckmannSeparable;
  }
  bool is_separable() const {
    return model_ == FacetModel::GgxSeparable || model_ == FacetModel::BeckmannSeparable;
  }
  static float clamp_alpha(float alpha) {
    return alpha > kMinAlpha ? std::min(alpha, kMaxAlpha) : kMinAlpha;  // also catches NaN
  }

  /// Unnormalised. A uniform point of the spherical cap that the reflections off a hemisphere fill.
  /// Source: Dupuy & Benyoub 2023, "Sampling visible GGX normals with spherical caps".
  static Vec3 ggx_visible(const Vec3& w, const Vec2& u) {
    const float z = (1.F - u.y) * (1.F + w.z) - w.z;
    const float r = std::sqrt(std::max(0.F, 1.F - z * z));
    const float phi = 2.F * kPi * u.x;
    return {r * std::cos(phi) + w.x, r * std::sin(phi) + w.y, z + w.z};
  }

  /// `m` is the normal of the point of the cap: it mirrors `w` to that point.
  static Vec2 ggx_inverse(const Vec3& w, const Vec3& m) {
    const float twice = 2.F * dot(w, m);
    const Vec3 c = m * twice - w;
    const float y = 1.F - twice * m.z / (1.F + w.z);
    return {warp::turn_of({c.x, c.y}), std::clamp(y, 0.F, kOneMinusEpsilon)};
  }
  static Vec2 beckmann_inverse(const Vec3& w, const Vec3& m);

  static float beckmann_projected_area(float z, float s);
  /// Unnormalised. Source: Heitz & d'Eon 2014 (slopes conditioned on the view), with the cumulative
  /// distribution inverted by a safeguarded Newton iteration as Jakob 2014 suggests.
  static Vec3 beckmann_visible(const Vec3& w, const Vec2& u);

  float alpha_x_ = 1.F;
  float alpha_y_ = 1.F;
  FacetModel model_ = FacetModel::Ggx;
};

/// The numbers by which facets that mirror `wo` into `wi` are sampled as visible ones, with the
/// density of `wi`. Zero unless both are on the same side.
inline LobeInverse mirror_inverse(const Microfacets& facets, const Vec3& wo, const Vec3& wi) {
  if (!same_hemisphere(wo, wi)) return {};
  const bool front = wo.z > 0.F;
  const Vec3 o = front ? wo : -wo;
  const Vec3 h = half_vector(o, front ? wi : -wi).h;
  return {facets.invert_visible(o, h), 0.25F * facets.density(h) / facets.projected_area(o)};
}

/// Inverse error function for |x| < 1, relative error below 1e-6 in single precision.
float inverse_erf(float x);

/// pbrt-v3's artist-friendly roughness (0 smooth, 1 rough) as a microfacet α.
float roughness_to_alpha(float roughness);

}  // namespace ajar
