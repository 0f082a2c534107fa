#pragma once
#include "scene/bsdf/coat_table.h"
#include "scene/bsdf/cosine_sampled.h"
#include "scene/bsdf/fresnel_mirror.h"
#include "scene/bsdf/microfacet_reflection.h"
#include "scene/bsdf/under_layer.h"

/// Transparent coats of a dielectric over any base: both sides of the surface are coated alike. A
/// coat reflects part of the light and transmits the rest, twice for light that the base scatters;
/// `Coat::transmittance` is that share, so that coat and base together never reflect more than
/// comes in.
namespace ajar {

/// Fresnel term of the inside of a coat, seen from outside: `eta` ≥ 1 from either side.
struct CoatFresnel {
  float eta = 1.5F;
  Spectrum operator()(float cos_i, bool /*front*/) const {
    return Spectrum(fresnel_dielectric(cos_i, eta).reflectance);
  }
};

using RoughCoat = MicrofacetReflection<CoatFresnel>;
using SmoothCoat = FresnelMirror<CoatFresnel>;

/// Transmittance of the facets of a rough coat to the base and back. Renderers differ.
enum class CoatPass : std::uint8_t {
  Whole,     ///< all that they do not reflect
  Smooth,    ///< as a smooth coat, or `Whole` where that is less
  Single,    ///< by `coat_table::refracted`; the rest goes back to the base
  Lossy,     ///< all that they do not reflect, with internal reflection by
             ///< `coat_table::mean_reflected_inside`
  LossySum,  ///< all that they do not reflect, with `coat_table::sum_reflected_inside`
};

/// A coat as its base sees it.
class Coat {
 public:
  Coat() = default;
  /// `alpha` is the roughness of its facets, 0 for a smooth one; `bounces` how often light may meet
  /// the base, 0 for any number of times.
  Coat(float eta, float alpha, FacetModel model = FacetModel::Ggx, CoatPass pass = CoatPass::Whole,
       int bounces = 0)
      : eta_(eta),
        alpha_(packed_alpha(alpha)),
        model_(model),
        pass_(pass),
        bounces_(static_cast<std::uint8_t>(bounces < 256 ? bounces : 0)) {}

  float eta() const { return eta_; }
  int bounces() const { return bounces_; }

  /// Share of light that comes through, one way, at this cosine of the direction outside. Never
  /// more than 1 − `reflectance`.
  float transmittance(float cosine) const;
  /// Mean of `transmittance` over a hemisphere, weighted by the cosine.
  float mean_transmittance() const;
  /// Share of light that the coat's own facets reflect, outside.
  float reflectance(float cosine) const;
  /// Share of diffuse light inside that is turned back to the base.
  float turned_back() const;

  /// Direction inside of the coat that `w` is refracted from, on the same side of the surface. Its
  /// cosine is written so that nothing cancels where both are small (η near 1, grazing angles).
  Vec3 inside(const Vec3& w) const {
    return {w.x / eta_, w.y / eta_,
            std::copysign(std::sqrt(eta_ * eta_ - 1.F + w.z * w.z) / eta_, w.z)};
  }
  /// dω inside / dω outside: cos θ / (η² cos θ').
  float solid_angle_ratio(const Vec3& outer, const Vec3& inner) const {
    return std::abs(outer.z / inner.z) / (eta_ * eta_);
  }
  /// 1 + x + x² + …, as many terms as there are bounces.
  float series(float x) const {
    x = std::min(x, 1.F - 1e-6F);
    const float terms = bounces_ > 0 ? 1.F - std::pow(x, static_cast<float>(bounces_)) : 1.F;
    return terms / (1.F - x);
  }

 private:
  /// α in steps of 1/65535, the resolution of the tables; keeps metals with their coats small.
  static std::uint16_t packed_alpha(float alpha) {
    return alpha > 0.F ? static_cast<std::uint16_t>(std::ceil(std::min(alpha, 1.F) * 65535.F)) : 0;
  }
  float alpha() const { return static_cast<float>(alpha_) / 65535.F; }
  RoughBoundary boundary() const { return {model_, eta_, alpha()}; }

  float eta_ = 1.5F;
  std::uint16_t alpha_ = 0;
  FacetModel model_ : 2 = FacetModel::Ggx;
  CoatPass pass_ : 3 = CoatPass::Whole;
  std::uint8_t bounces_ = 0;
};

/// Absorption by the medium of a coat.
struct CoatInside {
  Spectrum depth{0.F};  ///< optical thickness of the coat, along the normal
  /// Attenuation as if the coat bent nothing, and only on the ways in and out (Tungsten's
  /// plastics).
  bool straight = false;
};

/// Diffuse base under a coat, with the reflections between the two: T(θ_o) T(θ_i) r (1 + x + x² +
/// …) / (π η²), x = r F a², where F is the coat's reflectance of diffuse light from inside and a
/// the transmittance of one way through it. T is weakened by exp(−depth / cos θ'), θ' being the
/// refracted angle (but see `CoatInside`). A white base gives all back that a clear coat lets
/// through. Source: Wolff 1994, "Diffuse-reflectance model for smooth dielectric surfaces"; T of
/// rough coats as above.
struct CoatedDiffuse : CosineSampled<CoatedDiffuse> {
  PackedSpectrum base;  ///< r (1 + x + x² + …) / η²
  Coat coat;
  PackedSpectrum depth;
  bool straight = false;

  CoatedDiffuse() = default;
  CoatedDiffuse(const Spectrum& reflectance, const Coat& above, const CoatInside& inside = {});

  /// π f(wo, wi).
  Spectrum times_pi(const Vec3& wo, const Vec3& wi) const {
    return base.unpack() * passed(wo) * passed(wi);
  }
  Spectrum albedo(const Vec3& wo) const {
    return base.unpack() * passed(wo) * left(0.8F) * coat.mean_transmittance();
  }

 private:
  /// Transmittance of the coat along a way at this cosine. Never 0, so that no product of such is
  /// too small for a float.
  Spectrum left(float cosine) const {
    const Spectrum thickness = depth.unpack();
    if (thickness.is_black()) return Spectrum(1.F);
    constexpr float kBlack = 20.F;
    return map_lanes(thickness, [=](float x) {
      return std::exp(-std::min(x / std::max(cosine, kGrazing), kBlack));
    });
  }
  Spectrum passed(const Vec3& w) const {
    const float cosine = std::abs(straight ? w.z : coat.inside(w).z);
    return left(cosine) * coat.transmittance(std::abs(w.z));
  }
};

/// Reflectance of a metal under a coat for the cosines of both directions outside, with the
/// reflections between the two as if both were smooth: T(θ_o) T(θ_i) R (1 + x + x² + …), x = R F,
/// with R the metal's term inside of the coat, and F the smaller of the coat's reflectances of the
/// two directions, so that no energy is gained.
inline Spectrum coated_reflectance(const Spectrum& metal, const Coat& coat, float cos_o,
                                   float cos_i) {
  const float through = coat.transmittance(cos_o) * coat.transmittance(cos_i);
  if (coat.bounces() == 1) return metal * through;
  const float reflected = std::min(coat.reflectance(cos_o), coat.reflectance(cos_i));
  return map_lanes(metal, [&](float r) { return through * r * coat.series(r * reflected); });
}

/// Rough metal under a coat: light is refracted, reflected off the metal's facets and refracted
/// again. Light that meets the coat from inside beyond the critical angle is lost.
struct CoatedConductor {
  static constexpr bool kSpecular = false;
  Microfacets facets;        ///< facets of the metal, with the blur of a rough coat
  ConductorFresnel fresnel;  ///< index of the metal relative to the coat
  Coat coat;

  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode) const {
    if (transmission || !same_hemisphere(wo, wi)) return {};
    const Vec3 o = coat.inside(wo);
    const Vec3 i = coat.inside(wi);
    const HalfVector half = half_vector(o, i);
    const float density = 0.25F * facets.density(half.h);
    const float area_o = facets.projected_area(o);
    const float area_i = facets.projected_area(i);
    const float cos_o = std::abs(o.z);
    const float cos_i = std::abs(i.z);
    const float shadowing = facets.shadowing_over_cosines(cos_o, area_o, cos_i, area_i);
    const float ratio = coat.solid_angle_ratio(wi, i);
    return {weight(wo, wi, half.cosine) * (density * shadowing * cos_i * ratio),
            density / area_o * ratio, density / area_i * coat.solid_angle_ratio(wo, o)};
  }

  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3&,
                                   TransportMode) const {
    const bool front = wo.z > 0.F;
    const Vec3 outer_o = front ? wo : -wo;
    const Vec3 o = coat.inside(outer_o);
    const Vec3 h = facets.sample_visible(o, u.direction);
    const float cos_h = dot(o, h);
    const Vec3 i = h * (2.F * cos_h) - o;
    const float x = i.x * coat.eta();
    const float y = i.y * coat.eta();
    const float squared = 1.F - x * x - y * y;
    if (!(i.z > 0.F && cos_h > 0.F && squared > kGrazing * kGrazing)) return std::nullopt;
    const Vec3 outer_i(x, y, std::sqrt(squared));
    const float area_o = facets.projected_area(o);
    const float area_i = facets.projected_area(i);
    const float density = 0.25F * facets.density(h);
    if (!(density > 0.F)) return std::nullopt;
    // D and the solid angles cancel.
    const float shadowing = facets.shadowing_over_cosines(o.z, area_o, i.z, area_i);
    return LobeSample{front ? outer_i : -outer_i,
                      weight(outer_o, outer_i, std::min(1.F, cos_h)) * (shadowing * area_o * i.z),
                      density / area_o * coat.solid_angle_ratio(outer_i, i),
                      density / area_i * coat.solid_angle_ratio(outer_o, o)};
  }

  LobeInverse inverse(const Vec3& wo, const Vec3& wi, float, const Vec3&) const {
    if (!same_hemisphere(wo, wi)) return {};
    const Vec3 i = coat.inside(wi);
    LobeInverse result = mirror_inverse(facets, coat.inside(wo), i);
    result.pdf *= coat.solid_angle_ratio(wi, i);
    return result;
  }

  Spectrum albedo(const Vec3& wo) const {
    return weight(wo, wo, 0.95F * std::abs(coat.inside(wo).z));
  }

 private:
  Spectrum weight(const Vec3& wo, const Vec3& wi, float cos_h) const {
    return coated_reflectance(fresnel(cos_h, true), coat, std::abs(wo.z), std::abs(wi.z));
  }
};

/// The part that `CoatedConductor` lacks under a smooth coat: light that a rough metal reflects to
/// where the coat turns it back, most of it totally, and that comes out later. By then it is
/// diffuse: X(θ_o) X(θ_i) c / π, where X is the share that is turned back at first, and c such that
/// on average as much comes out as metal and coat leave of it. No direction gets more than the
/// other lobe lacks. Source of the form: Kulla & Conty 2017, "Revisiting physically based shading
/// at Imageworks".
struct CoatedConductorEcho : CosineSampled<CoatedConductorEcho> {
  PackedSpectrum share;  ///< c
  RoughBoundary below;   ///< the index of the coat and the facets of the metal

  CoatedConductorEcho() = default;
  /// The roughness of the metal is the mean of both.
  explicit CoatedConductorEcho(const CoatedConductor& first);

  /// π f(wo, wi).
  Spectrum times_pi(const Vec3& wo, const Vec3& wi) const {
    return share.unpack() * (returned(wo) * returned(wi));
  }
  Spectrum albedo(const Vec3& wo) const {
    return share.unpack() * (returned(wo) * coat_table::mean_returned(below));
  }

 private:
  float returned(const Vec3& w) const { return coat_table::returned(below, std::abs(w.z)); }
};

/// Index of refraction of varnish. Source: KHR_materials_clearcoat.
inline constexpr float kVarnishIndex = 1.5F;

/// Varnish over a share of the surface. KHR_materials_clearcoat weakens the base once, by the
/// varnish's reflectance; here that is the larger of the two directions, so that the base stays
/// reciprocal, and reflects no more than comes in together with the varnish.
struct Varnish {
  float alpha = 0.F;  ///< roughness; 0 for a smooth one
  float share = 1.F;  ///< may be 0

  float left(const Vec3& wo, const Vec3& wi) const {
    if (share == 0.F) return 1.F;
    // The larger cosine has the higher transmittance.
    return covered(coat().transmittance(std::min(std::abs(wo.z), std::abs(wi.z))));
  }
  float left_albedo(const Vec3& wo) const {
    if (share == 0.F) return 1.F;
    const Coat its = coat();
    return covered(std::min(its.transmittance(std::abs(wo.z)), its.mean_transmittance()));
  }

 private:
  Coat coat() const { return {kVarnishIndex, alpha}; }
  float covered(float through) const { return 1.F + share * (through - 1.F); }
};

template <typename Base>
using CoatAttenuated = UnderLayer<Base, Varnish>;

/// Both layers smooth: one mirror with the reflectance of the coat and the metal below it.
struct CoatedConductorFresnel {
  ConductorFresnel metal;  ///< relative to the coat
  Coat coat;               ///< a smooth one
  PackedSpectrum depth;    ///< optical thickness of the coat, along the normal
  Spectrum operator()(float cos_i, bool /*front*/) const {
    const DielectricBoundary boundary = fresnel_dielectric(cos_i, coat.eta());
    if (!(boundary.cos_t > 0.F)) return Spectrum(boundary.reflectance);
    const Spectrum left = map_lanes(depth.unpack(), [&](float x) {
      return x > 0.F ? std::exp(-2.F * x / boundary.cos_t) : 1.F;
    });
    return Spectrum(boundary.reflectance) +
           coated_reflectance(metal(boundary.cos_t, true) * left, coat, cos_i, cos_i);
  }
};
using SmoothCoatedConductor = FresnelMirror<CoatedConductorFresnel>;

}  // namespace ajar
