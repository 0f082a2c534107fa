#pragma once
#include <cstdint>
#include <optional>

#include "core/spectrum.h"
#include "core/unit_interval.h"
#include "core/vector.h"
#include "core/warp.h"

/// Interface of a lobe. A lobe is a trivially copyable struct with
///
///     static constexpr bool kSpecular;
///     LobeValue evaluate(wo, wi, transmission, mode) const;       // not if kSpecular
///     std::optional<LobeSample> sample(wo, u, ng, mode) const;
///     Spectrum albedo(wo) const;
///
/// and what undoes `sample` (docs/methods/inverses.md):
///
///     LobeInverse inverse(wo, wi, u_lobe, ng) const;              // not if kSpecular
///     UnitInterval choices(wo, wi, transmission, float& u) const; // only if it looks at u.lobe
///     bool is_diffuse(wo, u_lobe) const;                          // only if it ever is
///
/// `inverse` is told the number `u_lobe`. `choices` are those of the values of `u_lobe` by which
/// the lobe can have come to `wi`; where it can have by more than one way, `u` decides for one and
/// is made uniform again. `is_diffuse` says whether the lobe, with this number, spreads light over
/// the hemisphere without regard to `wo`. All of this is in the local frame whose z axis is the
/// shading normal: `wo` and `wi` point away from the surface, and neither is closer than `kGrazing`
/// to the horizon. `Bsdf` has already decided by the geometric normal whether a pair is
/// `transmission`; a lobe returns zero for pairs that it does not scatter. Factors for the shading
/// normal (Veach 1997, section 5.3) are applied by `Bsdf`, too.
namespace ajar {

/// Quantity transported along the sampled path: radiance (paths from the camera) or importance
/// (paths from lights). They differ where light is refracted and where shading normals are used.
enum class TransportMode : std::uint8_t { Radiance, Importance };

/// Uniform numbers one scattering event consumes.
struct BsdfUniforms {
  float lobe;
  Vec2 direction;
};

/// Directions whose |cosine| to a normal is below this scatter nothing: they carry no energy that
/// single precision could resolve, and it keeps every quotient of cosines finite.
inline constexpr float kGrazing = 1e-6F;

struct LobeValue {
  Spectrum value;           ///< f(wo, wi) · |cos θ_i|
  float pdf = 0.F;          ///< density of wi given wo, 1/sr
  float reverse_pdf = 0.F;  ///< density of wo given wi, 1/sr
};

struct LobeSample {
  Vec3 wi;
  Spectrum weight;    ///< f(wo, wi) · |cos θ_i| / pdf
  float pdf;          ///< density of wi given wo, 1/sr, or a probability if the lobe is specular
  float reverse_pdf;  ///< density of wo given wi through the same lobe
  bool transmission = false;
  float eta = 1.F;  ///< index of refraction on wi's side over that on wo's
};

/// Numbers by which a lobe samples a given direction.
struct LobeInverse {
  Vec2 direction{0.F, 0.F};
  float pdf = 0.F;  ///< density of the direction, by these numbers alone, 1/sr; 0: it never does
};

/// A `Spectrum` in twelve bytes, for storage inside lobes.
struct PackedSpectrum {
  float lanes[3] = {0.F, 0.F, 0.F};
  PackedSpectrum() = default;
  explicit PackedSpectrum(const Spectrum& s) : lanes{s[0], s[1], s[2]} {}
  Spectrum unpack() const { return {lanes[0], lanes[1], lanes[2]}; }
  float average() const { return (lanes[0] + lanes[1] + lanes[2]) * (1.F / 3.F); }
};

inline float pow5(float x) {
  const float squared = x * x;
  return squared * squared * x;
}
/// Schlick's weight (1 − |cos θ|)⁵. Source: Schlick 1994.
inline float schlick_weight(float cosine) { return pow5(std::clamp(1.F - cosine, 0.F, 1.F)); }

/// True if both directions are on the same side of the shading normal's plane.
inline bool same_hemisphere(const Vec3& a, const Vec3& b) { return a.z * b.z > 0.F; }

/// Normal of the facet that mirrors one direction into the other. Both must be in the same
/// hemisphere.
struct HalfVector {
  Vec3 h;
  float cosine;  ///< cosine of the angle from h to either direction, > 0
};
inline HalfVector half_vector(const Vec3& wo, const Vec3& wi) {
  const Vec3 sum = wo + wi;
  const float size = length(sum);
  // Half the length is the cosine, and stays positive where the dot product rounds to zero.
  return {sum / size, std::min(1.F, 0.5F * size)};
}

/// Cosine-weighted direction in the hemisphere of the *geometric* normal `ng` (in local
/// coordinates, pointing to the wanted side): density |cos θ| / π there, θ to the shading normal.
/// The part of the shading hemisphere that lies behind `ng` is mirrored at the origin, which maps
/// it exactly on the part of the geometric hemisphere that the shading hemisphere misses and keeps
/// |cos θ|. So diffuse lobes need not reject, and surfaces seen from behind their shading normal do
/// not turn black.
inline Vec3 cosine_around(const Vec2& u, const Vec3& ng) {
  const Vec3 w = warp::cosine_hemisphere(u);
  return dot(w, ng) < 0.F ? -w : w;
}

/// Density of `cosine_around`, given that the direction is in the right geometric hemisphere.
inline float cosine_pdf(const Vec3& w) { return std::abs(w.z) * kInvPi; }

/// Inverse of `cosine_around`.
inline LobeInverse cosine_inverse(const Vec3& w, const Vec3& ng) {
  if (!(dot(w, ng) > 0.F)) return {};
  const float side = std::copysign(1.F, w.z);
  return {warp::uniform_disk_inverse({side * w.x, side * w.y}), cosine_pdf(w)};
}

}  // namespace ajar
