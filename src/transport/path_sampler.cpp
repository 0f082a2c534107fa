#include "transport/path_sampler.h"

#include <algorithm>

namespace ajar {

namespace {
/// Density in the vertex measure with which a ray leaving an endpoint arrives at a vertex: the
/// inverse of the conventions in `Departure`.
double arrival_density(Pdf<Departure> departure, bool from_infinity, double distance,
                       float cosine) {
  const double spread = from_infinity ? 1.0 : 1.0 / (distance * distance);
  return static_cast<double>(departure.value()) * static_cast<double>(cosine) * spread;
}

/// |cos θ| at an endpoint over d²: what turns a direction density at the other end into the
/// endpoint's measure.
double endpoint_geometry(const Endpoint& endpoint, const EndpointPoint& point, const Vec3& w,
                         double distance) {
  if (endpoint.at_infinity()) return 1.0;
  return static_cast<double>(abs_dot(point.surface.ng, w)) / (distance * distance);
}

/// The ray between two points that were already moved off their surfaces; it stops a few roundings
/// short.
Ray ray_between(const Vec3& from, const Vec3& to) {
  const Vec3 difference = to - from;
  const float distance = length(difference);
  return {from, difference / distance, distance * (1.F - 0x1p-20F)};
}

/// From `vertex` to the endpoint that lies in direction `w`.
Ray ray_to_endpoint(const PathVertex& vertex, const Endpoint& endpoint,
                    const ConnectionSample& sample) {
  const Vec3 origin = vertex.ray_origin(sample.w);
  if (endpoint.at_infinity()) return {origin, sample.w, sample.distance};
  return ray_between(origin,
                     offset_ray_origin(sample.point.surface.p, sample.point.surface.ng, -sample.w));
}
}  // namespace

PathSampler::PathSampler(const Scene& scene, const PathSamplerSettings& settings)
    : scene_(scene),
      settings_(settings),
      camera_walk_{TransportMode::Radiance, Stream::Camera, settings.heuristic,
                   settings.roulette_start, settings.techniques.needs_light_subpath()},
      light_walk_{TransportMode::Importance, Stream::Light, settings.heuristic,
                  settings.roulette_start, true} {
  if (settings.techniques.classes().inner) {
    light_vertices_.resize(static_cast<std::size_t>(std::max(0, settings.max_depth)));
  }
}

double PathSampler::light_side_coefficient(int vertices) const {
  const TechniqueSet::Classes& classes = settings_.techniques.classes();
  if (vertices == 0) return classes.implicit ? 1.0 : 0.0;
  if (vertices == 1) return classes.next_event ? 1.0 : 0.0;
  return classes.inner ? 1.0 : 0.0;
}

double PathSampler::camera_side_coefficient(int vertices) const {
  if (vertices == 0) return 0.0;
  if (vertices == 1) return light_tracing_coefficient_;
  return settings_.techniques.classes().inner ? 1.0 : 0.0;
}

SegmentEnd PathSampler::trace(const WalkSettings& walk, const Flight& flight,
                              SampleSource& source) {
  return trace_segment(scene_, flight.ray, flight.medium, {source, walk.stream, flight.edges},
                       rays_);
}

void PathSampler::sample(SampleSource& source, const Vec2& raster, PathSink& sink) {
  light_vertex_count_ = 0;
  if (settings_.techniques.classes().inner) trace_light(source, sink);
  trace_camera(source, raster, sink);
}

void PathSampler::sample_light(SampleSource& source, PathSink& sink) { trace_light(source, sink); }

void PathSampler::trace_light(SampleSource& source, PathSink& sink) {
  if (scene_.light_sampler().empty()) return;
  const ChosenLight chosen =
      scene_.light_sampler().choose_emitter(source.get({Stream::Light, 0, kEmitterChoice}));
  EmissionUniforms u{};
  u.primitive = source.get({Stream::Light, 0, kEmissionPrimitive});
  u.position = source.get_pair({Stream::Light, 0, kEmissionPosition});
  u.direction = source.get_pair({Stream::Light, 0, kEmissionDirection});
  const Light& light = *chosen.light;
  const std::optional<EmissionSample> emission = light.sample_emission(u);
  if (!emission) return;

  sink.started(Stream::Light, light, emission->point);
  const float emitter_probability = chosen.probability.value();
  const double position_density = static_cast<double>(emission->position_pdf.value()) *
                                  static_cast<double>(emitter_probability);
  Flight flight;
  flight.ray = {light.at_infinity()
                    ? emission->origin
                    : offset_ray_origin(emission->origin, emission->point.surface.ng, emission->w),
                emission->w};
  flight.medium = light.medium;
  flight.reference = emission->point.surface.p;
  flight.throughput = emission->weight / emitter_probability;
  flight.mis = mis_start(settings_.heuristic, position_density,
                         light.discrete_position() ? 0.0 : light_side_coefficient(0));
  flight.departure = emission->departure_pdf.value();
  flight.from_infinity = light.at_infinity();
  flight.cosine = light.at_infinity() ? 1.F : abs_dot(emission->point.surface.ng, emission->w);

  const TechniqueSet::Classes& classes = settings_.techniques.classes();
  // A light subpath of n edges takes part in paths of at least n + 1 edges.
  while (flight.edges + 2 <= settings_.max_depth) {
    const SegmentEnd end = trace(light_walk_, flight, source);
    if (!end.hit && !end.scattered) return;
    PathVertex vertex = arrive(light_walk_, flight, end, light_side_coefficient(flight.edges + 1));
    if (vertex.throughput.is_black()) return;
    if (vertex.edges == 1) {
      // Technique (1, k) samples the light as seen from z_1, which may differ from how it emits.
      const double connection =
          static_cast<double>(light.connection_pdf(vertex.p, emission->point).value()) *
          static_cast<double>(scene_.light_sampler().probability(vertex.p, light).value());
      vertex.mis.coefficient *= h(settings_.heuristic, connection / position_density);
    }
    sink.vertex(Stream::Light, vertex);
    if (vertex.connectible()) {
      if (classes.light && vertex.edges + 1 >= settings_.min_depth) {
        connect_to_camera(vertex, source, sink);
      }
      if (classes.inner) light_vertices_[light_vertex_count_++] = vertex;
    }
    if (!scatter(light_walk_, vertex, source, flight)) return;
    sink.scattered(Stream::Light, vertex, flight);
  }
}

void PathSampler::trace_camera(SampleSource& source, const Vec2& raster, PathSink& sink) {
  const Camera& camera = scene_.camera();
  const Vec2 size(camera.resolution());
  EmissionUniforms u{};
  u.position = source.get_pair({Stream::Camera, 0, kEmissionPosition});
  u.direction = {raster.x / size.x, raster.y / size.y};
  const std::optional<EmissionSample> emission = camera.sample_emission(u);
  if (!emission) return;

  sink.started(Stream::Camera, camera, emission->point);
  const TechniqueSet::Classes& classes = settings_.techniques.classes();
  // Light tracing reaches the full image only, while wide filters draw camera rays from beyond its
  // border.
  const bool inside = raster.x >= 0.F && raster.y >= 0.F && raster.x < size.x && raster.y < size.y;
  light_tracing_coefficient_ =
      classes.light && inside ? h(settings_.heuristic, settings_.light_paths_per_pixel) : 0.0;

  Flight flight;
  flight.ray = {emission->origin, emission->w};
  flight.medium = camera.medium;
  flight.reference = emission->point.surface.p;
  flight.throughput = emission->weight;
  flight.mis = mis_start(settings_.heuristic, emission->position_pdf.value(), 0.0);
  flight.departure = emission->departure_pdf.value();
  flight.from_infinity = camera.at_infinity();
  flight.cosine =
      camera.discrete_position() ? 1.F : abs_dot(emission->point.surface.ng, emission->w);

  const bool walks_on = classes.implicit || classes.next_event || classes.inner;
  const int last_edge = walks_on ? settings_.max_depth : 1;
  while (flight.edges < settings_.max_depth) {
    const SegmentEnd end = trace(camera_walk_, flight, source);
    const int edges = flight.edges + 1;
    const bool sees_light =
        settings_.techniques.enabled({0, edges + 1}) && edges >= settings_.min_depth;
    if (!end.hit && !end.scattered) {
      if (!sees_light) return;
      const MisStep step = mis_step(flight, end.segment, end.distance, 1.F, nullptr, true,
                                    camera_side_coefficient(edges));
      const MisState mis = mis_extend(settings_.heuristic, flight.mis, step);
      for (const Light* light : scene_.infinite_lights()) {
        hit_light(flight, end, mis, *light, light->at_direction(flight.ray.direction), sink);
      }
      return;
    }
    const PathVertex vertex = arrive(camera_walk_, flight, end, camera_side_coefficient(edges));
    sink.vertex(Stream::Camera, vertex);
    if (edges == 1) sink.first_vertex(vertex, end.hit ? &*end.hit : nullptr, end.distance);
    if (end.hit && end.hit->light != nullptr && sees_light) {
      hit_light(flight, end, vertex.mis, *end.hit->light, {end.hit->point, Vec3(0.F)}, sink);
    }
    if (edges >= last_edge || vertex.throughput.is_black()) return;
    if (vertex.connectible()) {
      if (classes.next_event && edges + 1 >= settings_.min_depth) {
        connect_to_light(vertex, source, sink);
      }
      for (std::size_t i = 0; i < light_vertex_count_; ++i) {
        connect_inner(vertex, light_vertices_[i], sink);
      }
    }
    if (!scatter(camera_walk_, vertex, source, flight)) return;
    sink.scattered(Stream::Camera, vertex, flight);
  }
}

void PathSampler::hit_light(const Flight& flight, const SegmentEnd& end, const MisState& mis,
                            const Light& light, const EndpointPoint& point, PathSink& sink) const {
  const Spectrum emitted = light.emitted(point, -flight.ray.direction);
  if (emitted.is_black()) return;
  const int edges = flight.edges + 1;
  double others = 0.0;
  if (edges > 1) {
    // Technique (1, k) samples the light as seen from z_{i-1}; all with s ≥ 2 as it emits.
    const Heuristic heuristic = settings_.heuristic;
    const Vec3& reference = flight.reference;
    if (settings_.techniques.classes().next_event && !flight.specular) {
      const double connection =
          static_cast<double>(light.connection_pdf(reference, point).value()) *
          static_cast<double>(scene_.light_sampler().probability(reference, light).value());
      others += h(heuristic, connection) * mis.inverse_forward;
    }
    if (mis.partial > 0.0) {
      const EmissionPdf emission = light.emission_pdf(point, -flight.ray.direction);
      const double position =
          static_cast<double>(emission.position.value()) *
          static_cast<double>(scene_.light_sampler().emitter_probability(light).value());
      others += h(heuristic, position) *
                h(heuristic, static_cast<double>(emission.departure.value())) * mis.partial;
    }
  }
  const double mis_weight = 1.0 / (1.0 + others);
  sink.add({.value = flight.throughput * end.weight * emitted * static_cast<float>(mis_weight),
            .technique = {0, edges + 1},
            .mis_weight = mis_weight,
            .light_point = &point,
            .light = &light});
}

void PathSampler::connect_to_light(const PathVertex& vertex, SampleSource& source, PathSink& sink) {
  const LightSampler& lights = scene_.light_sampler();
  if (lights.empty()) return;
  const ChosenLight chosen =
      lights.choose(vertex.p, source.get({Stream::Camera, vertex.edges, Slot::LightChoice}));
  ConnectionUniforms u{};
  u.primitive = source.get({Stream::Camera, vertex.edges, Slot::LightPrimitive});
  u.position = source.get_pair({Stream::Camera, vertex.edges, Slot::LightPositionX});
  const Light& light = *chosen.light;
  const std::optional<ConnectionSample> sample = light.sample_connection(vertex.p, u);
  if (!sample) return;
  const float probability = chosen.probability.value();
  const BsdfValue scattered = vertex.evaluate(sample->w, TransportMode::Radiance);
  const Spectrum unoccluded = vertex.throughput * scattered.value * sample->weight / probability;
  if (unoccluded.is_black()) return;

  const std::optional<Segment> segment = connect(scene_, ray_to_endpoint(vertex, light, *sample),
                                                 vertex.medium_toward(sample->w), rays_);
  if (!segment) return;

  const Heuristic heuristic = settings_.heuristic;
  const double connection_density =
      static_cast<double>(sample->pdf.value()) * static_cast<double>(probability);
  const auto distance = static_cast<double>(sample->distance);
  double others = 0.0;
  if (!light.discrete_position() && settings_.techniques.classes().implicit) {
    const double reverse = static_cast<double>(scattered.pdf.value()) *
                           endpoint_geometry(light, sample->point, sample->w, distance) *
                           static_cast<double>(segment->distance_pdf(nullptr));
    others += h(heuristic, reverse / connection_density);
  }
  if (settings_.techniques.needs_light_subpath()) {
    const EmissionPdf emission = light.emission_pdf(sample->point, -sample->w);
    const double position = static_cast<double>(emission.position.value()) *
                            static_cast<double>(lights.emitter_probability(light).value());
    const double arrival =
        arrival_density(emission.departure, light.at_infinity(), distance,
                        vertex.cosine(sample->w)) *
        static_cast<double>(segment->distance_pdf(vertex.in_medium ? vertex.medium : nullptr));
    others += h(heuristic, position / connection_density) *
              vertex.mis.sum(heuristic, arrival, vertex.pdf(sample->w, vertex.wo).value());
  }
  const double mis_weight = 1.0 / (1.0 + others);
  sink.add({.value = unoccluded * segment->transmittance * static_cast<float>(mis_weight),
            .technique = {1, vertex.edges + 1},
            .mis_weight = mis_weight,
            .light_point = &sample->point,
            .light = &light});
}

void PathSampler::connect_to_camera(const PathVertex& vertex, SampleSource& source,
                                    PathSink& sink) {
  const Camera& camera = scene_.camera();
  ConnectionUniforms u{};
  u.position = source.get_pair({Stream::Light, vertex.edges, Slot::LightPositionX});
  const std::optional<ConnectionSample> sample = camera.sample_connection(vertex.p, u);
  if (!sample) return;
  const std::optional<Vec2> raster = camera.raster(sample->point, -sample->w);
  if (!raster || !sink.reaches(*raster)) return;
  const Spectrum unoccluded =
      vertex.throughput * vertex.eval(sample->w, TransportMode::Importance) * sample->weight;
  if (unoccluded.is_black()) return;
  const std::optional<Segment> segment = connect(scene_, ray_to_endpoint(vertex, camera, *sample),
                                                 vertex.medium_toward(sample->w), rays_);
  if (!segment) return;

  const auto distance = static_cast<double>(sample->distance);
  const EmissionPdf emission = camera.emission_pdf(sample->point, -sample->w);
  const double arrival =
      arrival_density(emission.departure, camera.at_infinity(), distance,
                      vertex.cosine(sample->w)) *
      static_cast<double>(segment->distance_pdf(vertex.in_medium ? vertex.medium : nullptr));
  const double others =
      vertex.mis.sum(settings_.heuristic, arrival, vertex.pdf(sample->w, vertex.wo).value()) /
      h(settings_.heuristic, settings_.light_paths_per_pixel);
  const double mis_weight = 1.0 / (1.0 + others);
  const double scale = mis_weight / settings_.light_paths_per_pixel;
  sink.add({.value = unoccluded * segment->transmittance * static_cast<float>(scale),
            .technique = {vertex.edges + 1, 1},
            .mis_weight = mis_weight,
            .raster = *raster,
            .camera_point = &sample->point});
}

void PathSampler::connect_inner(const PathVertex& camera_vertex, const PathVertex& light_vertex,
                                PathSink& sink) {
  const Technique technique{light_vertex.edges + 1, camera_vertex.edges + 1};
  if (technique.depth() < settings_.min_depth || technique.depth() > settings_.max_depth) return;
  const Vec3 difference = light_vertex.p - camera_vertex.p;
  const float distance_squared = length_squared(difference);
  if (distance_squared == 0.F) return;
  const float distance = std::sqrt(distance_squared);
  const Vec3 w = difference / distance;  // camera vertex → light vertex
  const Spectrum unoccluded = camera_vertex.throughput * light_vertex.throughput *
                              camera_vertex.eval(w, TransportMode::Radiance) *
                              light_vertex.eval(-w, TransportMode::Importance) / distance_squared;
  if (unoccluded.is_black()) return;
  const std::optional<Segment> segment =
      connect(scene_, ray_between(camera_vertex.ray_origin(w), light_vertex.ray_origin(-w)),
              camera_vertex.medium_toward(w), rays_);
  if (!segment) return;

  const Heuristic heuristic = settings_.heuristic;
  const double inverse_square = 1.0 / static_cast<double>(distance_squared);
  const double to_camera_vertex =
      static_cast<double>(light_vertex.pdf(light_vertex.wo, -w).value()) *
      static_cast<double>(camera_vertex.cosine(w)) * inverse_square *
      static_cast<double>(
          segment->distance_pdf(camera_vertex.in_medium ? camera_vertex.medium : nullptr));
  const double to_light_vertex =
      static_cast<double>(camera_vertex.pdf(camera_vertex.wo, w).value()) *
      static_cast<double>(light_vertex.cosine(w)) * inverse_square *
      static_cast<double>(
          segment->distance_pdf(light_vertex.in_medium ? light_vertex.medium : nullptr));
  const double others = camera_vertex.mis.sum(heuristic, to_camera_vertex,
                                              camera_vertex.pdf(w, camera_vertex.wo).value()) +
                        light_vertex.mis.sum(heuristic, to_light_vertex,
                                             light_vertex.pdf(-w, light_vertex.wo).value());
  const double mis_weight = 1.0 / (1.0 + others);
  sink.add({.value = unoccluded * segment->transmittance * static_cast<float>(mis_weight),
            .technique = technique,
            .mis_weight = mis_weight});
}

}  // namespace ajar
