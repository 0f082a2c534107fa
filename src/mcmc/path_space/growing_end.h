#pragma once
#include <optional>
#include <vector>

#include "path/path.h"
#include "transport/sample_source.h"

namespace ajar {

/// One end of a path in the making: an endpoint, and the vertices that a subpath from there has in
/// the scene, in the order of its making. It grows in two steps: away from the last vertex, then to
/// the next one. Numbers of a source are asked for at the addresses that `PathSampler` has for
/// them, and give the densities of `light_step_pdf` and `camera_step_pdf`.
class GrowingEnd {
 public:
  GrowingEnd(const Scene& scene, Stream stream) : scene_(scene), stream_(stream) {}

  /// Takes over vertices of `path`, the endpoint among them.
  void keep(const Path& path, int vertices);
  /// An endpoint that has been chosen from the other end; no vertex yet.
  void start(const Endpoint& endpoint, const EndpointPoint& point);
  /// One that sets off along a ray in `medium`.
  void start(const Endpoint& endpoint, const EndpointPoint& point, const Ray& ray,
             const Medium* medium);

  // Away from the last vertex; false if there is no such way.

  /// Samples the scattering of the surface or the medium.
  bool scatter(SampleSource& source);
  /// By a specular event.
  bool follow(const ScatterEvent& event);
  /// By all rough lobes.
  void go(const Vec3& direction);

  /// To the next vertex; false if nothing is there.
  bool arrive(SampleSource& source);
  /// Traces a segment and returns how it ended.
  SegmentEnd trace(SampleSource& source);

  /// The endpoint among them.
  int size() const { return endpoint == nullptr ? 0 : static_cast<int>(vertices.size()) + 1; }
  const Vec3& position() const { return vertices.empty() ? point.surface.p : vertices.back().p(); }
  /// From the last vertex in the scene toward the one before it.
  Vec3 back() const;
  const Vec3& direction() const { return ray_.direction; }
  const RayCounts& ray_counts() const { return rays_; }

  const Endpoint* endpoint = nullptr;
  EndpointPoint point = EndpointPoint::at(Vec3(0.F));
  std::vector<InnerVertex> vertices;
  std::vector<Segment> segments;  ///< `segments[i]` leads to `vertices[i]`

 private:
  void leave(const Vec3& direction);

  const Scene& scene_;
  Stream stream_;
  Ray ray_;
  const Medium* medium_ = nullptr;
  RayCounts rays_;
};

}  // namespace ajar
