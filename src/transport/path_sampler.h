#pragma once
#include <cstdint>
#include <vector>

#include "transport/sample_source.h"
#include "transport/subpath.h"
#include "transport/technique_set.h"

namespace ajar {

/// One path's share of the picture, found by one technique.
struct Contribution {
  Spectrum value;  ///< f / p · MIS weight
  Technique technique;
  double mis_weight;
  /// Technique (s, 1) only: where on the film it lands. All others belong to the camera ray's own
  /// place.
  Vec2 raster{0.F, 0.F};
  /// The endpoints that the last connection chose; null where the technique has none.
  const EndpointPoint* light_point = nullptr;
  const EndpointPoint* camera_point = nullptr;
  const Light* light = nullptr;
};

/// Receives what a `PathSampler` finds. Vertices are reported before the contributions that use
/// them.
class PathSink {
 public:
  virtual ~PathSink() = default;
  virtual void add(const Contribution& contribution) = 0;
  /// Whether light traced to this raster position would count at all.
  virtual bool reaches(const Vec2& /*raster*/) const { return true; }
  /// The first surface or medium vertex the camera sees, at `distance` from it; `hit` is null for a
  /// medium vertex.
  virtual void first_vertex(const PathVertex& /*vertex*/, const Hit* /*hit*/, float /*distance*/) {}
  /// Where a subpath starts, every vertex of it, and how it went on from there: for verification.
  virtual void started(Stream /*stream*/, const Endpoint& /*endpoint*/,
                       const EndpointPoint& /*point*/) {}
  virtual void vertex(Stream /*stream*/, const PathVertex& /*vertex*/) {}
  virtual void scattered(Stream /*stream*/, const PathVertex& /*vertex*/,
                         const Flight& /*flight*/) {}
};

struct PathSamplerSettings {
  TechniqueSet techniques = TechniqueSet::pt();
  Heuristic heuristic = Heuristic::Power;
  int min_depth = 1;
  int max_depth = 100;     ///< edges
  int roulette_start = 5;  ///< edges from which Russian roulette may end a subpath
  /// Light subpaths per sample index, divided by the pixels of the full image.
  double light_paths_per_pixel = 1.0;
};

/// Samples paths by any set of techniques (METHODS, section 2) as a deterministic function of a
/// primary vector. Holds the scratch memory of one thread; nothing is allocated after construction.
class PathSampler {
 public:
  PathSampler(const Scene& scene, const PathSamplerSettings& settings);

  /// One camera subpath through `raster` (pixels of the full image) with everything that hangs on
  /// it: implicit and next-event techniques and, if the set has inner techniques, a light subpath
  /// with all its connections.
  void sample(SampleSource& source, const Vec2& raster, PathSink& sink);
  /// One light subpath alone, connected to the lens: technique (s, 1).
  void sample_light(SampleSource& source, PathSink& sink);

  /// Rays traced so far.
  std::uint64_t rays() const { return rays_; }

 private:
  void trace_light(SampleSource& source, PathSink& sink);
  void trace_camera(SampleSource& source, const Vec2& raster, PathSink& sink);
  SegmentEnd trace(const WalkSettings& walk, const Flight& flight, SampleSource& source);
  void hit_light(const Flight& flight, const SegmentEnd& end, const MisState& mis,
                 const Light& light, const EndpointPoint& point, PathSink& sink) const;
  void connect_to_light(const PathVertex& vertex, SampleSource& source, PathSink& sink);
  void connect_to_camera(const PathVertex& vertex, SampleSource& source, PathSink& sink);
  void connect_inner(const PathVertex& camera_vertex, const PathVertex& light_vertex,
                     PathSink& sink);
  double light_side_coefficient(int vertices) const;
  double camera_side_coefficient(int vertices) const;

  const Scene& scene_;
  PathSamplerSettings settings_;
  WalkSettings camera_walk_;
  WalkSettings light_walk_;
  double light_tracing_coefficient_ = 0.0;  ///< of technique (s, 1) for the current camera path
  std::vector<PathVertex> light_vertices_;
  std::size_t light_vertex_count_ = 0;
  std::uint64_t rays_ = 0;
};

}  // namespace ajar
