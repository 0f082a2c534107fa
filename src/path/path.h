#pragma once
#include <vector>

#include "scene/bsdf/bsdf.h"
#include "scene/scene.h"
#include "transport/segment.h"

namespace ajar {

/// A hit that has a place and nothing else.
inline Hit bare_hit(const Vec3& p) {
  return {{0.F, 0, 0, EndpointPoint::at(p).surface, false}, nullptr, nullptr, nullptr, 0, 0};
}

/// A vertex of a path between its ends: x_1 … x_{k-1}, on a surface or in a medium. The state to
/// scatter there again, in any direction, is held by value.
struct InnerVertex {
  Hit hit = bare_hit(Vec3(0.F));  ///< hit of the surface; inside a medium only the position
  /// Inside a medium, this one; on surfaces that rays cross without changing their medium, theirs.
  const Medium* medium = nullptr;
  bool in_medium = false;
  /// Scattering event on this path: a specular lobe, or all rough ones; and the side. Unset in a
  /// medium.
  ScatterEvent event;
  Bsdf bsdf;  ///< BSDF of the surface, made by its material at `hit.point`

  const Vec3& p() const { return hit.point.p; }
  /// f · |cos θ|, or the phase function, of the rough lobes.
  Spectrum eval(const Vec3& wo, const Vec3& wi, TransportMode mode) const;
  /// Density of `to` given that the path came from `from`: of the rough lobes, or the probability
  /// of the specular event.
  double pdf(const Vec3& from, const Vec3& to) const;
  /// |cos θ| of the geometric normal with `w`; 1 inside media, which have no orientation.
  float cosine(const Vec3& w) const { return in_medium ? 1.F : abs_dot(hit.point.ng, w); }
  /// The medium that a ray leaving along `w` is in.
  const Medium* medium_toward(const Vec3& w) const;
  /// Without a medium on surfaces.
  MediumPoint scattered_in() const { return {in_medium ? medium : nullptr, p()}; }
  /// Where a ray leaving along `w` starts.
  Vec3 ray_origin(const Vec3& w) const {
    return in_medium ? p() : offset_ray_origin(p(), hit.point.ng, w);
  }
  /// Where a ray ends that comes from `distance` away along −`w`.
  Vec3 ray_end(const Vec3& w, float distance) const {
    return in_medium ? p() : offset_ray_end(p(), hit.point.ng, w, distance);
  }
  bool connectible() const { return in_medium || bsdf.connectible(); }
  /// True for a vertex that does not count in the depth.
  bool is_uncounted() const { return !in_medium && bsdf.is_uncounted(event); }
};

/// A whole path x_0 … x_k, x_0 on a light, x_k on the camera: nothing in it is random, and nothing
/// says how it was made. Copying over a path that was as long costs no allocation, so chains that
/// hold a current and a proposed path go without heap.
///
/// Edge i joins x_i and x_{i+1}; `vertices[i]` is x_{i+1}.
struct Path {
  const Light* light = nullptr;
  EndpointPoint light_point = EndpointPoint::at(Vec3(0.F));
  EndpointPoint camera_point = EndpointPoint::at(Vec3(0.F));
  Vec2 raster{0.F, 0.F};  ///< where it lands on the film, pixels of the full image
  std::vector<InnerVertex> vertices;
  std::vector<Segment> segments;  ///< by edge: k of them

  /// Edges, k.
  int depth() const { return static_cast<int>(vertices.size()) + 1; }
  /// Edges, less those of events that do not count, and as many more as interfaces that do.
  int counted_depth() const;
  const InnerVertex& vertex(int x) const { return vertices[static_cast<std::size_t>(x - 1)]; }
  const Segment& segment(int edge) const { return segments[static_cast<std::size_t>(edge)]; }

  // Unit directions, by the number x of the vertex in 0 … k.

  /// From x to x − 1, for x ≥ 1.
  Vec3 toward_light(const Scene& scene, int x) const;
  /// From x to x + 1, for x < k.
  Vec3 toward_camera(const Scene& scene, int x) const;
  /// Position of a vertex that is not at infinity.
  const Vec3& position(int x) const;
  /// Between two vertices that have a place.
  double squared_distance(int x, int y) const {
    const Vec3d d = Vec3d(position(y)) - Vec3d(position(x));
    return d.dot(d);
  }
};

/// True if a camera that hides lights sees this edge: all vertices between are uncounted events and
/// interfaces.
bool is_seen_past_lights(const Scene& scene, const Path& path, int edge);
/// True if the light of the path, or an emissive surface on its way, is hidden from the camera.
bool is_hidden(const Scene& scene, const Path& path);

/// Sets `event.transmission` of the vertices that scatter by rough lobes; unsampled events leave it
/// unset.
void mark_sides(const Scene& scene, Path& path);

}  // namespace ajar
