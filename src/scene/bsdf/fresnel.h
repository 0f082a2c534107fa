#pragma once
#include "scene/bsdf/lobe.h"

/// Reflectance of smooth boundaries, unpolarised light.
namespace ajar {

struct DielectricBoundary {
  float reflectance;  ///< in [0, 1]; 1 under total internal reflection
  float cos_t;        ///< cosine of the refracted angle, ≥ 0; 0 under total internal reflection
};

/// Reflectance of light polarised in the plane of incidence, and across it.
struct PolarisedReflectance {
  float parallel;
  float perpendicular;
};

/// Fresnel's equations with both angles known: `cos_i` in front of the boundary, `cos_t` behind it,
/// both ≥ 0 and not both 0. Unlike `fresnel_dielectric` it keeps its digits close to total
/// reflection, and gives the same seen from either side.
inline PolarisedReflectance fresnel_polarised(float cos_i, float cos_t, float eta) {
  const float parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  const float perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  return {parallel * parallel, perpendicular * perpendicular};
}
/// The mean of both, of light that is not polarised.
inline float fresnel_reflectance(float cos_i, float cos_t, float eta) {
  const auto [parallel, perpendicular] = fresnel_polarised(cos_i, cos_t, eta);
  return 0.5F * (parallel + perpendicular);
}

/// Exact Fresnel equations. `cos_i` in [0, 1]; `eta` is the index of refraction behind the boundary
/// over that in front of it, > 0.
inline DielectricBoundary fresnel_dielectric(float cos_i, float eta) {
  if (eta == 1.F) return {0.F, cos_i};
  const float sin2_t = std::max(0.F, 1.F - cos_i * cos_i) / (eta * eta);
  if (sin2_t >= 1.F) return {1.F, 0.F};
  const float cos_t = std::sqrt(1.F - sin2_t);
  return {fresnel_reflectance(cos_i, cos_t, eta), cos_t};
}

/// Exact Fresnel equations for a metal seen from vacuum, lane by lane: index of refraction `eta` >
/// 0, absorption `k` ≥ 0, `cos_i` in [0, 1]. Source: Lagarde 2013, "Memo on Fresnel equations".
inline Spectrum fresnel_conductor(float cos_i, const PackedSpectrum& eta, const PackedSpectrum& k) {
  using Lanes = Spectrum::Lanes;
  const auto square_root = [](const Lanes& x) {
    return Lanes{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
  };
  // The unused lane is vacuum without absorption, which is as safe as any metal.
  const Lanes n{eta.lanes[0], eta.lanes[1], eta.lanes[2], 1.F};
  const Lanes absorption{k.lanes[0], k.lanes[1], k.lanes[2], 0.F};
  const float c2 = cos_i * cos_i;
  const float s2 = 1.F - c2;
  const Lanes eta2 = n * n;
  const Lanes k2 = absorption * absorption;
  const Lanes t0 = eta2 - k2 - s2;
  const Lanes a2_plus_b2 = square_root(t0 * t0 + 4.F * eta2 * k2);
  const Lanes t1 = a2_plus_b2 + c2;
  const Lanes twice_a2 = a2_plus_b2 + t0;
  const Lanes zero{};
  const Lanes a = square_root(0.5F * (twice_a2 > zero ? twice_a2 : zero));
  const Lanes t2 = 2.F * cos_i * a;
  const Lanes perpendicular = (t1 - t2) / (t1 + t2);
  const Lanes t3 = c2 * a2_plus_b2 + s2 * s2;
  const Lanes t4 = t2 * s2;
  const Lanes parallel = perpendicular * (t3 - t4) / (t3 + t4);
  const Lanes r = 0.5F * (parallel + perpendicular);
  return {r[0], r[1], r[2]};
}

/// Fresnel term of a dielectric. `eta` is the index behind the surface (−z) over that in front of
/// it.
struct DielectricFresnel {
  float eta = 1.5F;
  /// `front`: seen from +z.
  Spectrum operator()(float cos_i, bool front) const {
    return Spectrum(fresnel_dielectric(cos_i, front ? eta : 1.F / eta).reflectance);
  }
};

/// Fresnel term of a metal, the same from both sides.
struct ConductorFresnel {
  PackedSpectrum eta;
  PackedSpectrum k;
  ConductorFresnel() = default;
  /// Clamped to eta ≥ 1e-4 and both ≤ 1e4, where the equations are safe in single precision.
  ConductorFresnel(const Spectrum& index, const Spectrum& absorption)
      : eta(map_lanes(index, [](float x) { return x > 1e-4F ? std::min(x, 1e4F) : 1e-4F; })),
        k(map_lanes(absorption, [](float x) { return x > 0.F ? std::min(x, 1e4F) : 0.F; })) {}
  Spectrum operator()(float cos_i, bool /*front*/) const {
    return fresnel_conductor(cos_i, eta, k);
  }
};

}  // namespace ajar
