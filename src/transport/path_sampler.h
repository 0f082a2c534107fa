#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "transport/counted_depth.h"
#include "transport/efficiency_cells.h"
#include "transport/sample_source.h"
#include "transport/subpath.h"
#include "transport/technique_set.h"

namespace ajar {

/// One path's share of the picture, found by one technique.
struct Contribution {
  Spectrum value;  ///< f / p · MIS weight
  Technique technique;
  double mis_weight;
  /// Roulette weight in `value`: the factor of survivors of Russian roulette and of the culling of
  /// weak connections. Without it, `value` is a function of the path and its technique.
  float roulette_weight = 1.F;
  /// Technique (0, t) only: no edge of the path could have been made by a connection, since one end
  /// of each scatters by a specular lobe.
  bool unidirectional_only = false;
  int light_subpath = 0;  ///< index of the sample's light subpath, if s ≥ 2
  /// Technique (s, 1) only: where on the film it lands. All others belong to the camera ray's own
  /// place.
  Vec2 raster{0.F, 0.F};
  /// The endpoints that the last connection chose; null where the technique has none.
  const EndpointPoint* light_point = nullptr;
  const EndpointPoint* camera_point = nullptr;
  const Light* light = nullptr;
  /// MIS weights that all techniques of each class together give the path; their sum is 1. Only
  /// with `PathSamplerSettings::shares_by_class`.
  ByTechniqueClass<float> shares{};
};

/// Receives the contributions of a `PathSampler`. Vertices are reported before the contributions
/// that use them.
class PathSink {
 public:
  virtual ~PathSink() = default;
  virtual void add(const Contribution& contribution) = 0;
  /// True if light traced to this raster position counts.
  virtual bool reaches(const Vec2& /*raster*/) const { return true; }
  /// Rays that one unit of light (largest lane) is worth at this raster position. Connections worth
  /// less than a ray are subject to Russian roulette in proportion.
  virtual float rays_per_unit_light(const Vec2& /*raster*/) const {
    return std::numeric_limits<float>::infinity();
  }
  /// Luminance that all contributions of camera subpaths together have brought, in units of
  /// `Contribution::value`: what of it efficiency is judged by (`PathSamplerSettings::cells`).
  virtual double brought() const { return 0.0; }
  /// Rays that all light is worth which light subpaths have brought to the lens.
  virtual double brought_to_lens() const { return 0.0; }
  /// True if the cells are told of the next subpaths.
  virtual bool learns() const { return false; }
  /// True if `rays_per_unit_light` is by the noise of the render, no guess. Else nothing is known
  /// of what light subpaths bring.
  virtual bool knows_price() const { return false; }
  /// The first surface or medium vertex the camera sees, at `distance` from it; `hit` is null for a
  /// medium vertex.
  virtual void first_vertex(const PathVertex& /*vertex*/, const Hit* /*hit*/, float /*distance*/) {}
  /// Start of a subpath, each of its vertices, and its continuation, for `PathRecorder`.
  virtual void started(Stream /*stream*/, const Endpoint& /*endpoint*/,
                       const EndpointPoint& /*point*/) {}
  /// `hit` is null for a medium vertex.
  virtual void vertex(Stream /*stream*/, const PathVertex& /*vertex*/, const Hit* /*hit*/) {}
  virtual void scattered(Stream /*stream*/, const PathVertex& /*vertex*/,
                         const Flight& /*flight*/) {}
};

struct PathSamplerSettings {
  TechniqueSet techniques = TechniqueSet::pt();
  Heuristic heuristic = Heuristic::Power;
  int min_depth = 1;
  int max_depth = 100;     ///< edges
  CountedDepth counted{};  ///< in addition to the limits of edges
  int roulette_start = 5;  ///< edges from which Russian roulette may end a subpath
  /// Light subpaths that `sample` traces and connects, on average; no more than
  /// `kMaxLightSubpaths`.
  double light_subpaths = 1.0;
  /// Light subpaths connected to the lens per call of `sample`, divided by the share of the full
  /// image's pixels that these calls cover. If `sample` traces them itself: `light_subpaths` times
  /// that share.
  double light_paths_per_pixel = 1.0;
  /// Camera subpaths survive by what is known here, and tell it what they bring; null: roulette
  /// follows the throughput alone. Must outlive the sampler.
  EfficiencyCells* cells = nullptr;
  /// Light subpaths survive by what is known here, by the rays that their light is worth; null:
  /// roulette follows the throughput alone.
  EfficiencyCells* light_cells = nullptr;
  /// Makes `Contribution::shares`, at a few more operations for each vertex of each connection.
  bool shares_by_class = false;
};

/// Where a sampler's rays have gone.
struct RaysByUse {
  std::uint64_t light_walk = 0;  ///< edges of light subpaths
  ByTechniqueClass<std::uint64_t> connections{};

  RaysByUse& operator+=(const RaysByUse& other) {
    light_walk += other.light_walk;
    for (std::size_t k = 0; k < connections.size(); ++k) connections[k] += other.connections[k];
    return *this;
  }
};

/// Samples paths by any set of techniques (docs/methods/bidirectional.md) as a deterministic
/// function of a primary vector. Holds the scratch memory of one thread; nothing is allocated after
/// construction.
///
/// Random decisions of a connection between the camera vertex of e edges and the light vertex of l
/// edges are addressed by `Stream::Connection`, vertex 256 (l mod 256) + (e mod 256).
class PathSampler {
 public:
  static constexpr int kMaxLightSubpaths = 32;

  PathSampler(const Scene& scene, const PathSamplerSettings& settings);

  /// One camera subpath through `raster` (pixels of the full image) with everything that hangs on
  /// it: implicit and next-event techniques and, if the set has inner techniques, light subpaths
  /// with all their connections.
  void sample(SampleSource& source, const Vec2& raster, PathSink& sink);
  /// One light subpath alone, connected to the lens: technique (s, 1).
  void sample_light(SampleSource& source, PathSink& sink);

  // One technique at a time, half by half, for chains that move one half and keep the other. All
  // paths must have the same depth (`min_depth` = `max_depth`). `observer` observes the vertices,
  // unless it is null: chains need none of them.

  /// The last of the `vertices` − 1 ≥ 1 vertices that a light subpath has in the scene; false if it
  /// does not get there, or cannot be connected.
  bool trace_light_half(SampleSource& source, int vertices, PathVertex& end, PathSink* observer);
  /// Traces a camera subpath.
  bool trace_camera_half(SampleSource& source, const Vec2& raster, int vertices, PathVertex& end,
                         PathSink* observer);
  /// Technique (s ≥ 1, t ≥ 1): a half of a single vertex is the endpoint alone, its `end` unused.
  void connect_halves(Technique technique, const PathVertex& light_end,
                      const PathVertex& camera_end, SampleSource& source, PathSink& sink);
  /// Technique (0, t).
  void sample_implicit(SampleSource& source, const Vec2& raster, int vertices, PathSink& sink,
                       PathSink* observer);

  /// Camera subpaths follow these directions, or are noted there; null: neither.
  void keep_directions(KeptDirections* directions) { camera_walk_.directions = directions; }

  /// Rays traced so far.
  std::uint64_t rays() const { return rays_.rays; }
  const RayCounts& ray_counts() const { return rays_; }
  const RaysByUse& rays_by_use() const { return rays_by_use_; }

 private:
  struct LightStart {
    const Light* light = nullptr;
    EndpointPoint point = EndpointPoint::at(Vec3(0.F));
    double position_density = 0.0;
    Flight flight;
  };
  bool start_light(SampleSource& source, int repeat, PathSink& sink, LightStart& start);
  bool next_light_vertex(LightStart& start, SampleSource& source, PathSink& sink,
                         PathVertex& vertex);
  bool start_camera(SampleSource& source, const Vec2& raster, PathSink& sink, Flight& flight);
  /// True if the camera looks past lights where this flight ended.
  static bool hides(const Flight& flight, const SegmentEnd& end);
  /// True if the counted depth of a path with this technique, whose parts have this surplus, is
  /// enabled.
  bool counts(Technique technique, int surplus) const {
    return settings_.counted.holds(technique.depth() + surplus);
  }
  /// A camera path that runs into the lights at infinity.
  void leave_scene(const Flight& flight, const SegmentEnd& end, PathSink& sink);
  // Halves, in path_halves.cpp. Templated, so that the null observer compiles away.
  template <typename Observer>
  bool light_half(SampleSource& source, int vertices, PathVertex& end, Observer& observer);
  template <typename Observer>
  bool camera_half(SampleSource& source, const Vec2& raster, int vertices, PathVertex& end,
                   Observer& observer);
  template <typename Observer>
  void implicit(SampleSource& source, const Vec2& raster, int vertices, PathSink& sink,
                Observer& observer);
  void trace_light(SampleSource& source, PathSink& sink, int repeat);
  /// The rest of a light subpath.
  void walk_light(LightStart& start, SampleSource& source, PathSink& sink);
  void trace_camera(SampleSource& source, const Vec2& raster, PathSink& sink);
  /// The rest of a camera subpath.
  void walk_camera(Flight& flight, SampleSource& source, PathSink& sink);
  /// False if the subpath ends at this vertex.
  bool depart(const PathVertex& vertex, SampleSource& source, PathSink& sink, Flight& flight);

  // Efficiency, in path_efficiency.cpp.

  /// A subpath that leaves one of its vertices, to be told what it brought from there on.
  struct Departure {
    std::uint32_t cell;
    bool specular;
    /// Throughput, largest lane; of a light subpath, over that with which it set out.
    float left_with;
    double brought;  ///< before; then, of a light subpath, to the lens since
    std::uint64_t rays;
  };
  struct LightDeparture : Departure {
    // Its later vertices that may be connected: the first, and one past the last.
    std::size_t first_vertex;
    std::size_t end_vertex = 0;
  };
  /// Connections of a light vertex to those of a camera subpath.
  struct InnerConnections {
    double brought = 0.0;  ///< rays that their light is worth
    std::uint64_t rays = 0;
  };
  /// Tells cells what the camera subpath has brought.
  void learn(const PathSink& sink);
  /// False if the light subpath ends at this vertex.
  bool depart_from_light(const PathVertex& vertex, SampleSource& source, const PathSink& sink,
                         Flight& flight);
  /// Tells cells what light subpaths have brought.
  void learn_of_light();
  SegmentEnd trace(const WalkSettings& walk, const Flight& flight, SampleSource& source);

  // Connections, in path_connections.cpp.
  void hit_light(const Flight& flight, const SegmentEnd& end, const MisState& mis,
                 const Light& light, const EndpointPoint& point, PathSink& sink);
  void connect_to_lamps(const PathVertex& vertex, SampleSource& source, PathSink& sink);
  void connect_to_light_subpaths(const PathVertex& vertex, SampleSource& source, PathSink& sink);
  void connect_to_lights(const PathVertex& vertex, SampleSource& source, PathSink& sink);
  void connect_to_light(const PathVertex& vertex, SampleSource& source, int repeat, PathSink& sink);
  void connect_to_camera(const PathVertex& vertex, SampleSource& source, PathSink& sink);
  void connect_inner(const PathVertex& camera_vertex, const PathVertex& light_vertex,
                     SampleSource& source, PathSink& sink);
  /// Endpoints of a connection, for addressing its random numbers.
  struct Pair {
    int light_edges;
    int camera_edges;
    int repeat;
    int surplus;  ///< surplus of both
    SampleAddress address(Slot slot) const {
      return {Stream::Connection, light_edges % 256 * 256 + camera_edges % 256, slot, repeat};
    }
  };
  struct Joined {
    Spectrum value;  ///< MIS weight, transmittance and culling included
    double mis_weight;
    float culling;  ///< its share of `value`
  };
  /// Traces a connection that carries `unoccluded`; `weight_of(segment)` is its MIS weight. Empty
  /// if nothing arrives. Where no interfaces can lie between, visibility is tested last of all.
  template <typename WeightOf>
  std::optional<Joined> join(const Ray& ray, const Medium* medium, const Spectrum& unoccluded,
                             float rays_per_unit_light, const Pair& pair, SampleSource& source,
                             const WeightOf& weight_of);
  /// MIS weight of a technique. `others(kind)`: the other techniques of a class, or of all classes
  /// if it is empty, relative to it. Notes the shares of classes if they are asked for.
  template <typename OthersOf>
  double mis_weight(TechniqueClass own, const OthersOf& others);
  /// Decides about a connection that is made less than once on average.
  static bool is_tried(double count, const Pair& pair, SampleSource& source);
  /// Russian roulette of weak connections: weight of the survivors, 0 for the others.
  static float cull(const Spectrum& contribution, float rays_per_unit_light, const Pair& pair,
                    SampleSource& source);

  /// Samples of a technique per call of `sample`, or per pixel if they are light tracing's.
  double count(Technique technique) const;
  double light_side_coefficient(int vertices) const;
  double camera_side_coefficient(int vertices) const;
  double h_count(Technique technique) const;
  /// Techniques of this class alone, or of all.
  using OnlyClass = std::optional<TechniqueClass>;
  double h_count(Technique technique, OnlyClass only) const {
    return !only || class_of(technique) == *only ? h_count(technique) : 0.0;
  }
  MisState light_mis(const PathVertex& vertex, int depth, OnlyClass only) const;
  MisState camera_mis(const PathVertex& vertex, int depth, OnlyClass only) const;
  bool wants(Technique technique) const {
    const int depth = technique.depth();
    return depth >= settings_.min_depth && depth <= settings_.max_depth &&
           settings_.techniques.enabled(technique);
  }
  bool has(TechniqueClass kind) const { return settings_.techniques.any(kind); }

  const Scene& scene_;
  PathSamplerSettings settings_;
  WalkSettings camera_walk_;
  WalkSettings light_walk_;
  /// Depth of all paths, if it is one: coefficients of single techniques are then known at once.
  int only_depth_;
  /// h(count) of the techniques of each class, if they are all alike.
  ByTechniqueClass<double> class_h_count_;
  bool light_tracing_reaches_ = false;  ///< the current camera path's place on the film
  float rays_per_unit_light_ =
      std::numeric_limits<float>::infinity();  ///< rays per unit of light there
  std::vector<PathVertex> light_vertices_;
  std::size_t light_vertex_count_ = 0;
  /// True for sets that name single techniques, and where classes are told apart: the recursion is
  /// recorded in these two.
  bool keeps_trails_;
  std::vector<MisTrailEntry> camera_trail_;
  std::vector<MisTrailEntry> light_trails_;
  ByTechniqueClass<float> shares_{};  ///< shares of the last MIS weight
  bool learns_ = false;               ///< cells are told of it
  std::vector<Departure> departures_;
  bool knows_price_ = false;
  std::vector<LightDeparture> light_departures_;
  std::vector<InnerConnections> inner_connections_;  ///< light vertex by light vertex
  RayCounts rays_;
  RaysByUse rays_by_use_;
};

}  // namespace ajar
