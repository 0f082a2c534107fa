#pragma once
#include "scene/bsdf/fresnel.h"
#include "scene/bsdf/microfacet.h"

namespace ajar {

/// Rough boundary between two dielectrics: reflection and refraction at microfacets, each facet
/// choosing in proportion to their energy. `reflect` and `transmit` tint the two and may be black.
/// Source: Walter et al. 2007, eqs. 20 and 21.
struct RoughDielectric {
  static constexpr bool kSpecular = false;
  Microfacets facets;
  PackedSpectrum reflect;
  PackedSpectrum transmit;
  float eta = 1.5F;  ///< index behind the surface over that in front; not 1

  LobeValue evaluate(const Vec3& wo, const Vec3& wi, bool transmission, TransportMode mode) const {
    if (same_hemisphere(wo, wi) == transmission) return {};
    // Seen from the front: everything but the relative index is the same from both sides.
    const bool front = wo.z > 0.F;
    const float relative = front ? eta : 1.F / eta;
    const Vec3 o = front ? wo : -wo;
    const Vec3 i = front ? wi : -wi;
    const std::optional<Facet> f = facet(o, i, transmission, relative);
    if (!f) return {};
    return value(o, i, transmission, f->h, f->o_h, f->i_h, f->squared, relative, f->choice, mode);
  }

  std::optional<LobeSample> sample(const Vec3& wo, const BsdfUniforms& u, const Vec3&,
                                   TransportMode mode) const {
    const bool front = wo.z > 0.F;
    const float relative = front ? eta : 1.F / eta;
    const Vec3 o = front ? wo : -wo;
    const Vec3 h = facets.sample_visible(o, u.direction);
    const float o_h = std::min(1.F, dot(o, h));
    if (o_h <= 0.F) return std::nullopt;
    const Choice choice = choose(fresnel_dielectric(o_h, relative));
    const bool transmission = u.lobe >= choice.p_reflect;
    if (transmission && !(choice.p_transmit > 0.F)) return std::nullopt;
    const Vec3 i = transmission
                       ? h * (o_h / relative - choice.boundary.cos_t) - o * (1.F / relative)
                       : h * (2.F * o_h) - o;
    if (transmission ? i.z > -kGrazing : i.z < kGrazing) return std::nullopt;
    const float i_h = transmission ? -choice.boundary.cos_t : o_h;
    const float denominator = o_h + relative * i_h;
    const LobeValue v =
        value(o, i, transmission, h, o_h, i_h, denominator * denominator, relative, choice, mode);
    if (!(v.pdf > 0.F) || !std::isfinite(v.pdf)) return std::nullopt;
    return LobeSample{front ? i : -i, v.value / v.pdf, v.pdf,
                      v.reverse_pdf,  transmission,    transmission ? relative : 1.F};
  }

  LobeInverse inverse(const Vec3& wo, const Vec3& wi, float u_lobe, const Vec3&) const {
    const bool front = wo.z > 0.F;
    const float relative = front ? eta : 1.F / eta;
    const Vec3 o = front ? wo : -wo;
    const Vec3 i = front ? wi : -wi;
    const bool transmission = !same_hemisphere(wo, wi);
    const std::optional<Facet> f = facet(o, i, transmission, relative);
    if (!f || (u_lobe >= f->choice.p_reflect) != transmission) return {};
    // Value of `evaluate`, without the probability of the choice.
    const float density = facets.density(f->h) / facets.projected_area(o);
    const float pdf = transmission
                          ? density * f->o_h * std::abs(f->i_h) * relative * relative / f->squared
                          : 0.25F * density;
    return {facets.invert_visible(o, f->h), pdf};
  }
  UnitInterval choices(const Vec3& wo, const Vec3& wi, bool transmission, float&) const {
    const bool front = wo.z > 0.F;
    const float relative = front ? eta : 1.F / eta;
    const std::optional<Facet> f =
        facet(front ? wo : -wo, front ? wi : -wi, transmission, relative);
    const double p = f ? static_cast<double>(f->choice.p_reflect) : 0.0;
    return transmission ? UnitInterval{p, 1.0 - p} : UnitInterval{0.0, p};
  }

  Spectrum albedo(const Vec3& wo) const {
    // Where the mean surface reflects totally, some facets still transmit.
    const Spectrum f = clamp(DielectricFresnel{eta}(std::abs(wo.z), wo.z > 0.F), 0.F, 0.95F);
    return reflect.unpack() * f + transmit.unpack() * (Spectrum(1.F) - f);
  }

 private:
  struct Choice {
    DielectricBoundary boundary;
    float p_reflect;
    float p_transmit;
  };
  Choice choose(const DielectricBoundary& boundary) const {
    const float reflected = boundary.reflectance * reflect.average();
    const float transmitted = (1.F - boundary.reflectance) * transmit.average();
    const float sum = reflected + transmitted;
    if (!(sum > 0.F)) return {boundary, 0.F, 0.F};
    return {boundary, reflected / sum, transmitted / sum};
  }

  /// The facet that takes `o` to `i`, both seen from the front.
  struct Facet {
    Vec3 h;
    float o_h;
    float i_h;
    float squared;  ///< (o·h + η i·h)², of transmission
    Choice choice;
  };
  /// Empty if there is none.
  std::optional<Facet> facet(const Vec3& o, const Vec3& i, bool transmission,
                             float relative) const {
    if (!transmission) {
      const HalfVector half = half_vector(o, i);
      const Choice choice = choose(fresnel_dielectric(half.cosine, relative));
      return Facet{half.h, half.cosine, half.cosine, 0.F, choice};
    }
    const Vec3 sum = o + i * relative;
    const float squared = length_squared(sum);
    if (!(squared > 0.F)) return std::nullopt;
    const Vec3 h = sum / std::copysign(std::sqrt(squared), sum.z);
    const float o_h = std::min(1.F, dot(o, h));
    const float t_h = -dot(i, h);
    if (o_h <= 0.F || t_h <= 0.F) return std::nullopt;
    const Choice choice = choose({fresnel_reflectance(o_h, t_h, relative), t_h});
    return Facet{h, o_h, -t_h, squared, choice};
  }

  /// `squared` is (o·h + η i·h)², only used for transmission.
  LobeValue value(const Vec3& o, const Vec3& i, bool transmission, const Vec3& h, float o_h,
                  float i_h, float squared, float relative, const Choice& choice,
                  TransportMode mode) const {
    const float density = facets.density(h);
    const float cos_i = std::abs(i.z);
    const float area_o = facets.projected_area(o);
    const float area_i = facets.projected_area(i);
    const float shadowing = facets.shadowing_over_cosines(o.z, area_o, cos_i, area_i);
    const float reflectance = choice.boundary.reflectance;
    if (!transmission) {
      const float quarter = 0.25F * density;
      return {reflect.unpack() * (reflectance * quarter * shadowing * cos_i),
              choice.p_reflect * quarter / area_o, choice.p_reflect * quarter / area_i};
    }
    // Facet density to direction density: dh/di = η² |i·h| / (o·h + η i·h)², and for the reverse
    // event dh/do = |o·h| / (o·h + η i·h)².
    const float common = density * o_h * std::abs(i_h) / squared;
    const float eta2 = relative * relative;
    const float scale = mode == TransportMode::Radiance ? 1.F : eta2;
    return {transmit.unpack() * ((1.F - reflectance) * common * scale * shadowing * cos_i),
            choice.p_transmit * common * eta2 / area_o, choice.p_transmit * common / area_i};
  }
};

}  // namespace ajar
