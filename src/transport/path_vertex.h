#pragma once
#include <cstdint>
#include <optional>

#include "core/by_lane.h"
#include "scene/scene.h"
#include "transport/mis.h"

namespace ajar {

/// A vertex of a subpath inside the scene, on a surface or in a medium. Endpoints are not stored: a
/// path's light or camera vertex is sampled together with the connection to it. Holds no heap
/// memory.
struct PathVertex {
  Vec3 p;
  Vec3 wo;              ///< unit, toward the previous vertex
  Spectrum throughput;  ///< f / p of the subpath up to here, scattering here not included
  ByLane lanes;         ///< as in `FreeFlight`
  float roulette;       ///< the factor in it that comes from Russian roulette
  MisState mis;
  /// MIS trail of the whole subpath, indexed by `edges`; null unless the set names single
  /// techniques.
  const MisTrailEntry* trail = nullptr;
  const Medium* medium;          ///< medium that the subpath arrived through
  const MediumInterface* media;  ///< interface of the surface; null inside a medium
  int edges;  ///< edges of the subpath: the endpoint is vertex 0, this one is vertex `edges`
  /// By which the depth that counts is more than `edges`: interfaces that add to it, less the
  /// events that do not.
  int surplus;
  int repeat = 0;  ///< index of the light subpath of the sample
  bool in_medium;  ///< scatters in `medium` instead of at a surface
  bool on_light;   ///< the surface shines
  Bsdf bsdf;       ///< undefined inside a medium

  /// f · |cos θ| (media: phase function · σ_s, the density of scattering events times the direction
  /// density).
  Spectrum eval(const Vec3& wi, TransportMode mode) const;
  /// Density of `to` given that the path came from `from` (both unit, away from the vertex).
  Pdf<SolidAngle> pdf(const Vec3& from, const Vec3& to) const;
  /// `eval`, and the density of `wi` given that the path came from `wo`.
  BsdfValue evaluate(const Vec3& wi, TransportMode mode) const;
  std::optional<BsdfSample> sample(const BsdfUniforms& u, TransportMode mode,
                                   Reverse reverse) const;
  /// False if every scattering event here is specular.
  bool connectible() const { return in_medium || bsdf.connectible(); }
  /// |cos θ| of the geometric normal with `w`; 1 inside media, which have no orientation.
  float cosine(const Vec3& w) const { return in_medium ? 1.F : abs_dot(bsdf.ng(), w); }
  /// Without a medium on surfaces.
  MediumPoint scattered_in() const { return {in_medium ? medium : nullptr, p}; }
  /// The medium that a ray leaving along `w` is in.
  const Medium* medium_toward(const Vec3& w) const {
    if (in_medium || !media->changes) return medium;
    return dot(w, bsdf.ng()) > 0.F ? media->outside : media->inside;
  }
  /// Where a ray leaving along `w` starts.
  Vec3 ray_origin(const Vec3& w) const {
    return in_medium ? p : offset_ray_origin(p, bsdf.ng(), w);
  }
  /// Where a ray ends that comes from `distance` away along −`w`.
  Vec3 ray_end(const Vec3& w, float distance) const {
    return in_medium ? p : offset_ray_end(p, bsdf.ng(), w, distance);
  }
};

}  // namespace ajar
