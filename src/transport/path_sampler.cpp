#include "transport/path_sampler.h"

#include <algorithm>

namespace ajar {

PathSampler::PathSampler(const Scene& scene, const PathSamplerSettings& settings)
    : scene_(scene),
      settings_(settings),
      camera_walk_{TransportMode::Radiance, Stream::Camera, settings.heuristic,
                   settings.roulette_start, settings.techniques.needs_light_subpath()},
      light_walk_{TransportMode::Importance, Stream::Light, settings.heuristic,
                  settings.roulette_start, true},
      only_depth_(settings.min_depth == settings.max_depth && !settings.shares_by_class
                      ? settings.max_depth
                      : 0),
      keeps_trails_(only_depth_ == 0 &&
                    (!settings.techniques.uniform() || settings.shares_by_class)) {
  const TechniqueSet& set = settings_.techniques;
  const auto depth = static_cast<std::size_t>(std::max(0, settings.max_depth));
  const auto subpaths = static_cast<std::size_t>(std::ceil(settings.light_subpaths));
  if (has(TechniqueClass::Inner)) {
    light_vertices_.resize(subpaths * depth);
    inner_connections_.resize(subpaths * depth);
  }
  if (keeps_trails_) {
    camera_trail_.resize(depth + 1);
    light_trails_.resize(subpaths * (depth + 1));
    if (camera_walk_.has_other_end) camera_walk_.trail = camera_trail_.data();
  }
  const auto h_of = [&](TechniqueClass kind, double factor) {
    class_h_count_[index_of(kind)] = h(settings.heuristic, set.count(kind) * factor);
  };
  h_of(TechniqueClass::Implicit, 1.0);
  h_of(TechniqueClass::NextEvent, 1.0);
  h_of(TechniqueClass::Light, settings.light_paths_per_pixel);
  h_of(TechniqueClass::Inner, settings.light_subpaths);
}

double PathSampler::count(Technique technique) const {
  const double own = settings_.techniques.count(technique);
  if (technique.t == 1) return own * settings_.light_paths_per_pixel;
  return technique.s >= 2 ? own * settings_.light_subpaths : own;
}

double PathSampler::h_count(Technique technique) const {
  if (technique.t == 1 && !light_tracing_reaches_) return 0.0;
  return h(settings_.heuristic, count(technique));
}

double PathSampler::light_side_coefficient(int vertices) const {
  if (only_depth_ > 0) return h_count({vertices, only_depth_ + 1 - vertices});
  if (keeps_trails_) return 1.0;
  constexpr std::array<TechniqueClass, 3> kClasses = {
      TechniqueClass::Implicit, TechniqueClass::NextEvent, TechniqueClass::Inner};
  return class_h_count_[index_of(kClasses[static_cast<std::size_t>(std::min(vertices, 2))])];
}

double PathSampler::camera_side_coefficient(int vertices) const {
  if (vertices == 0) return 0.0;
  if (only_depth_ > 0) return h_count({only_depth_ + 1 - vertices, vertices});
  if (keeps_trails_) return 1.0;
  if (vertices >= 2) return class_h_count_[index_of(TechniqueClass::Inner)];
  return light_tracing_reaches_ ? class_h_count_[index_of(TechniqueClass::Light)] : 0.0;
}

MisState PathSampler::light_mis(const PathVertex& vertex, int depth, OnlyClass only) const {
  if (vertex.trail == nullptr) return vertex.mis;
  return mis_along(vertex.trail, vertex.edges, [&](int s) {
    return h_count({s, depth + 1 - s}, only);
  });
}

MisState PathSampler::camera_mis(const PathVertex& vertex, int depth, OnlyClass only) const {
  if (vertex.trail == nullptr) return vertex.mis;
  return mis_along(vertex.trail, vertex.edges, [&](int t) {
    return h_count({depth + 1 - t, t}, only);
  });
}

SegmentEnd PathSampler::trace(const WalkSettings& walk, const Flight& flight,
                              SampleSource& source) {
  const std::uint64_t before = rays_.rays;
  SegmentEnd end = trace_segment(scene_, flight.ray, flight.medium, flight.lanes,
                                 {source, walk.stream, flight.edges, walk.repeat}, rays_);
  if (walk.stream == Stream::Light) rays_by_use_.light_walk += rays_.rays - before;
  return end;
}

void PathSampler::sample(SampleSource& source, const Vec2& raster, PathSink& sink) {
  light_vertex_count_ = 0;
  learns_ = settings_.cells != nullptr && sink.learns();
  knows_price_ = sink.knows_price();
  if (has(TechniqueClass::Inner)) {
    const double whole = std::floor(settings_.light_subpaths);
    const double rest = settings_.light_subpaths - whole;
    int subpaths = static_cast<int>(whole);
    if (rest > 0.0 &&
        static_cast<double>(source.get({Stream::Connection, 0, kConnectionTry})) < rest) {
      ++subpaths;
    }
    for (int i = 0; i < subpaths; ++i) trace_light(source, sink, i);
  }
  trace_camera(source, raster, sink);
  learn_of_light();
}

void PathSampler::sample_light(SampleSource& source, PathSink& sink) {
  learns_ = sink.learns();
  knows_price_ = sink.knows_price();
  trace_light(source, sink, 0);
  learn_of_light();
}

bool PathSampler::start_light(SampleSource& source, int repeat, PathSink& sink, LightStart& start) {
  if (scene_.light_sampler().empty()) return false;
  const auto address = [&](Slot slot) { return SampleAddress(Stream::Light, 0, slot, repeat); };
  const ChosenLight chosen =
      scene_.light_sampler().choose_emitter(source.get(address(kEmitterChoice)));
  EmissionUniforms u{};
  u.primitive = source.get(address(kEmissionPrimitive));
  u.position = source.get_pair(address(kEmissionPosition));
  u.direction = source.get_pair(address(kEmissionDirection));
  const Light& light = *chosen.light;
  const std::optional<EmissionSample> emission = light.sample_emission(u);
  if (!emission) return false;

  sink.started(Stream::Light, light, emission->point);
  const float emitter_probability = chosen.probability.value();
  const double position_density = static_cast<double>(emission->position_pdf.value()) *
                                  static_cast<double>(emitter_probability);
  start.light = &light;
  start.point = emission->point;
  start.position_density = position_density;
  Flight& flight = start.flight;
  flight.ray = {light.at_infinity()
                    ? emission->origin
                    : offset_ray_origin(emission->origin, emission->point.surface.ng, emission->w),
                emission->w};
  flight.medium = light.medium;
  flight.reference = emission->point.surface.p;
  flight.throughput = emission->weight / emitter_probability;
  flight.roulette_scale = 1.F / flight.throughput.max();
  flight.mis = mis_start(settings_.heuristic, position_density,
                         light.discrete_position() ? 0.0 : light_side_coefficient(0));
  flight.departure = emission->departure_pdf.value();
  flight.from_infinity = light.at_infinity();
  flight.cosine = light.at_infinity() ? 1.F : abs_dot(emission->point.surface.ng, emission->w);

  light_walk_.repeat = repeat;
  if (!light_trails_.empty()) {
    light_walk_.trail = &light_trails_[static_cast<std::size_t>(repeat) *
                                       static_cast<std::size_t>(settings_.max_depth + 1)];
    light_walk_.trail[0] = {flight.mis.inverse_forward, flight.mis.coefficient};
  }
  // Connections to the lens from here on always end on the film.
  light_tracing_reaches_ = true;
  return true;
}

bool PathSampler::next_light_vertex(LightStart& start, SampleSource& source, PathSink& sink,
                                    PathVertex& vertex) {
  const Flight& flight = start.flight;
  const SegmentEnd end = trace(light_walk_, flight, source);
  if (!end.hit && !end.scattered) return false;
  arrive(light_walk_, flight, end, light_side_coefficient(flight.edges + 1), vertex);
  if (vertex.throughput.is_black()) return false;
  if (vertex.edges == 1) {
    // Technique (1, k) samples the light as seen from z_1, which may differ from how it emits.
    const Light& light = *start.light;
    const double connection =
        static_cast<double>(light.connection_pdf(vertex.p, start.point).value()) *
        static_cast<double>(scene_.light_sampler().probability(vertex.p, light).value());
    vertex.mis.coefficient *= h(settings_.heuristic, connection / start.position_density);
    if (vertex.trail != nullptr) light_walk_.trail[1].coefficient = vertex.mis.coefficient;
  }
  sink.vertex(Stream::Light, vertex, end.hit ? &*end.hit : nullptr);
  return true;
}

void PathSampler::trace_light(SampleSource& source, PathSink& sink, int repeat) {
  LightStart start;
  if (!start_light(source, repeat, sink, start)) return;
  const std::size_t first = light_departures_.size();
  walk_light(start, source, sink);
  for (std::size_t i = first; i < light_departures_.size(); ++i) {
    LightDeparture& from = light_departures_[i];
    from.brought = sink.brought_to_lens() - from.brought;
    from.rays = rays_.rays - from.rays;
    from.end_vertex = light_vertex_count_;
  }
}

void PathSampler::walk_light(LightStart& start, SampleSource& source, PathSink& sink) {
  Flight& flight = start.flight;
  // A light subpath of n edges takes part in paths of at least n + 1 edges.
  while (flight.edges + 2 <= settings_.max_depth) {
    PathVertex vertex;
    if (!next_light_vertex(start, source, sink, vertex)) return;
    if (vertex.connectible()) {
      if (wants({vertex.edges + 1, 1})) connect_to_camera(vertex, source, sink);
      if (has(TechniqueClass::Inner)) {
        inner_connections_[light_vertex_count_] = {};
        light_vertices_[light_vertex_count_++] = vertex;
      }
    }
    if (!depart_from_light(vertex, source, sink, flight)) return;
    if (flight.edges + flight.surplus + 2 > settings_.counted.maximum) return;
    sink.scattered(Stream::Light, vertex, flight);
  }
}

bool PathSampler::start_camera(SampleSource& source, const Vec2& raster, PathSink& sink,
                               Flight& flight) {
  const Camera& camera = scene_.camera();
  const Vec2 size(camera.resolution());
  const std::optional<EmissionSample> emission = camera_ray(camera, source, raster);
  if (!emission) return false;

  sink.started(Stream::Camera, camera, emission->point);
  // Light tracing reaches the full image only, while wide filters draw camera rays from beyond its
  // border.
  const bool inside = raster.x >= 0.F && raster.y >= 0.F && raster.x < size.x && raster.y < size.y;
  light_tracing_reaches_ = inside;
  rays_per_unit_light_ = sink.rays_per_unit_light(raster);

  flight.ray = {emission->origin, emission->w};
  flight.ray.passes_lights = scene_.hides_lights();
  flight.medium = camera.medium;
  flight.reference = emission->point.surface.p;
  flight.throughput = emission->weight;
  flight.mis = mis_start(settings_.heuristic, emission->position_pdf.value(), 0.0);
  flight.departure = emission->departure_pdf.value();
  flight.from_infinity = camera.at_infinity();
  flight.cosine =
      camera.discrete_position() ? 1.F : abs_dot(emission->point.surface.ng, emission->w);

  if (!camera_trail_.empty()) camera_trail_[0] = {flight.mis.inverse_forward, 0.0};
  return true;
}

bool PathSampler::hides(const Flight& flight, const SegmentEnd& end) {
  return flight.ray.passes_lights && end.segment.counted_interfaces == 0;
}

void PathSampler::leave_scene(const Flight& flight, const SegmentEnd& end, PathSink& sink) {
  if (end.lost || hides(flight, end)) return;
  const int edges = flight.edges + 1;
  const MisStep step =
      mis_step(flight, end.segment, end.distance, 1.F, {}, true, camera_side_coefficient(edges));
  MisState mis = mis_extend(settings_.heuristic, flight.mis, step);
  if (camera_walk_.trail != nullptr) {
    camera_walk_.trail[edges] = mis_trail_entry(settings_.heuristic, mis, step);
    mis = mis_along(camera_walk_.trail, edges, [&](int t) { return h_count({edges + 1 - t, t}); });
  }
  for (const Light* light : scene_.infinite_lights()) {
    hit_light(flight, end, mis, *light, light->at_direction(flight.ray.direction), sink);
  }
}

void PathSampler::trace_camera(SampleSource& source, const Vec2& raster, PathSink& sink) {
  Flight flight;
  if (start_camera(source, raster, sink, flight)) walk_camera(flight, source, sink);
  learn(sink);
}

void PathSampler::walk_camera(Flight& flight, SampleSource& source, PathSink& sink) {
  const bool walks_on =
      has(TechniqueClass::Implicit) || has(TechniqueClass::NextEvent) || has(TechniqueClass::Inner);
  const int last_edge = walks_on ? settings_.max_depth : 1;
  while (flight.edges < settings_.max_depth) {
    const SegmentEnd end = trace(camera_walk_, flight, source);
    const int edges = flight.edges + 1;
    const bool sees_light = wants({0, edges + 1});
    if (!end.hit && !end.scattered) {
      if (sees_light) leave_scene(flight, end, sink);
      return;
    }
    PathVertex vertex;
    arrive(camera_walk_, flight, end, camera_side_coefficient(edges), vertex);
    const Hit* hit = end.hit ? &*end.hit : nullptr;
    sink.vertex(Stream::Camera, vertex, hit);
    if (edges == 1) sink.first_vertex(vertex, hit, end.distance);
    if (end.hit && end.hit->light != nullptr && sees_light) {
      hit_light(flight, end, camera_mis(vertex, edges, {}), *end.hit->light,
                {end.hit->point, Vec3(0.F)}, sink);
    }
    if (edges >= last_edge || vertex.throughput.is_black()) return;
    connect_to_lamps(vertex, source, sink);
    connect_to_light_subpaths(vertex, source, sink);
    if (!depart(vertex, source, sink, flight)) return;
  }
}

void PathSampler::connect_to_lamps(const PathVertex& vertex, SampleSource& source, PathSink& sink) {
  if (vertex.connectible() && wants({1, vertex.edges + 1})) {
    connect_to_lights(vertex, source, sink);
  }
}

void PathSampler::connect_to_light_subpaths(const PathVertex& vertex, SampleSource& source,
                                            PathSink& sink) {
  if (!vertex.connectible()) return;
  for (std::size_t i = 0; i < light_vertex_count_; ++i) {
    const double brought = sink.brought();
    const std::uint64_t rays = rays_.rays;
    connect_inner(vertex, light_vertices_[i], source, sink);
    inner_connections_[i].brought +=
        (sink.brought() - brought) * static_cast<double>(rays_per_unit_light_);
    inner_connections_[i].rays += rays_.rays - rays;
  }
}

bool PathSampler::depart(const PathVertex& vertex, SampleSource& source, PathSink& sink,
                         Flight& flight) {
  WorthOfDirection in_rays = {0.F, 0.F};
  std::uint32_t cell = 0;
  if (settings_.cells != nullptr) {
    cell = settings_.cells->find(vertex);
    const EfficiencyCells::Worth& worth = settings_.cells->worth(cell);
    in_rays = {worth[0] * rays_per_unit_light_, worth[1] * rays_per_unit_light_};
  }
  if (!scatter(camera_walk_, vertex, source, flight, in_rays)) return false;
  if (flight.edges + flight.surplus >= settings_.counted.maximum) return false;
  if (learns_) {
    departures_.push_back({.cell = cell,
                           .specular = flight.specular,
                           .left_with = flight.throughput.max(),
                           .brought = sink.brought(),
                           .rays = rays_.rays});
  }
  sink.scattered(Stream::Camera, vertex, flight);
  return true;
}

}  // namespace ajar
