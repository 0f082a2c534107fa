#include <algorithm>

#include "transport/path_sampler.h"

namespace ajar {

namespace {
/// Density in the vertex measure with which a ray leaving an endpoint arrives at a vertex: the
/// inverse of the conventions in `Departure`.
double arrival_density(Pdf<Departure> departure, bool from_infinity, double distance,
                       float cosine) {
  const double spread = from_infinity ? 1.0 : 1.0 / (distance * distance);
  return static_cast<double>(departure.value()) * static_cast<double>(cosine) * spread;
}

/// |cos θ| at an endpoint over d²: factor from a direction density at the other end to the
/// endpoint's measure.
double endpoint_geometry(const Endpoint& endpoint, const EndpointPoint& point, const Vec3& w,
                         double distance) {
  if (endpoint.at_infinity()) return 1.0;
  return static_cast<double>(abs_dot(point.surface.ng, w)) / (distance * distance);
}

/// From `vertex` to the endpoint that lies in direction `w`.
Ray ray_to_endpoint(const PathVertex& vertex, const Endpoint& endpoint,
                    const ConnectionSample& sample) {
  const Vec3 origin = vertex.ray_origin(sample.w);
  if (endpoint.at_infinity()) return {origin, sample.w, sample.distance};
  const SurfacePoint& end = sample.point.surface;
  return ray_between(origin, offset_ray_end(end.p, end.ng, -sample.w, sample.distance));
}

/// Adds the rays of its lifetime to a sum.
class CountsRaysOf {
 public:
  CountsRaysOf(const RayCounts& rays, std::uint64_t& sum)
      : rays_(rays), sum_(sum), before_(rays.rays) {}
  ~CountsRaysOf() { sum_ += rays_.rays - before_; }
  CountsRaysOf(const CountsRaysOf&) = delete;
  CountsRaysOf& operator=(const CountsRaysOf&) = delete;

 private:
  const RayCounts& rays_;
  std::uint64_t& sum_;
  std::uint64_t before_;
};

}  // namespace

bool PathSampler::is_tried(double count, const Pair& pair, SampleSource& source) {
  return count >= 1.0 || static_cast<double>(source.get(pair.address(kConnectionTry))) < count;
}

float PathSampler::cull(const Spectrum& contribution, float rays_per_unit_light, const Pair& pair,
                        SampleSource& source) {
  const float survival = contribution.max() * rays_per_unit_light;
  if (!(survival < 1.F)) return 1.F;  // NaN is not culled
  return source.get(pair.address(kConnectionCull)) < survival ? 1.F / survival : 0.F;
}

template <typename OthersOf>
double PathSampler::mis_weight(TechniqueClass own, const OthersOf& others) {
  if (!settings_.shares_by_class) return 1.0 / (1.0 + others(std::nullopt));
  ByTechniqueClass<double> relative{};
  double others_of_own = 0.0;
  double sum = 1.0;
  for (std::size_t i = 0; i < relative.size(); ++i) {
    const auto kind = static_cast<TechniqueClass>(i);
    relative[i] = others(kind);
    sum += relative[i];
    if (kind == own) others_of_own = relative[i];
  }
  relative[index_of(own)] = 1.0 + others_of_own;
  for (std::size_t i = 0; i < relative.size(); ++i) {
    shares_[i] = static_cast<float>(relative[i] / sum);
  }
  return 1.0 / sum;
}

template <typename WeightOf>
std::optional<PathSampler::Joined> PathSampler::join(const Ray& ray, const Medium* medium,
                                                     const Spectrum& unoccluded,
                                                     float rays_per_unit_light, const Pair& pair,
                                                     SampleSource& source,
                                                     const WeightOf& weight_of) {
  const Technique technique{pair.light_edges + 1, pair.camera_edges + 1};
  const CountsRaysOf counts_rays(rays_, rays_by_use_.connections[index_of(class_of(technique))]);
  if (const std::optional<Segment> segment = unobstructed(scene_, ray, medium)) {
    if (!counts(technique, pair.surplus)) return std::nullopt;
    const double mis_weight = weight_of(*segment);
    const Spectrum value = unoccluded * segment->transmittance * static_cast<float>(mis_weight);
    if (value.is_black()) return std::nullopt;
    const float survivor = cull(value, rays_per_unit_light, pair, source);
    if (survivor == 0.F) return std::nullopt;
    if (is_blocked(scene_, ray, rays_)) return std::nullopt;
    return Joined{value * survivor, mis_weight, survivor};
  }
  const float survivor = cull(unoccluded, rays_per_unit_light, pair, source);
  if (survivor == 0.F) return std::nullopt;
  const std::optional<Segment> segment = connect(scene_, ray, medium, rays_);
  if (!segment || !counts(technique, pair.surplus + segment->counted_interfaces)) {
    return std::nullopt;
  }
  const double mis_weight = weight_of(*segment);
  return Joined{unoccluded * segment->transmittance * (survivor * static_cast<float>(mis_weight)),
                mis_weight, survivor};
}

void PathSampler::hit_light(const Flight& flight, const SegmentEnd& end, const MisState& mis,
                            const Light& light, const EndpointPoint& point, PathSink& sink) {
  const int edges = flight.edges + 1;
  if (!counts({0, edges + 1}, flight.surplus + end.segment.counted_interfaces)) return;
  const Spectrum emitted = light.emitted(point, -flight.ray.direction);
  if (emitted.is_black()) return;
  const auto others_of = [&](OnlyClass only) {
    double others = 0.0;
    if (edges <= 1) return others;
    // Technique (1, k) samples the light as seen from z_{i-1}; all with s ≥ 2 as it emits.
    const Heuristic heuristic = settings_.heuristic;
    const Vec3& reference = flight.reference;
    const double next_event = h_count({1, edges}, only);
    if (next_event > 0.0 && !flight.specular) {
      const double connection =
          static_cast<double>(light.connection_pdf(reference, point).value()) *
          static_cast<double>(scene_.light_sampler().probability(reference, light).value());
      others += next_event * h(heuristic, connection) * mean(mis.inverse_forward);
    }
    const double partial = mean(only ? mis_along(camera_walk_.trail, edges,
                                                 [&](int t) {
                                                   return h_count({edges + 1 - t, t}, only);
                                                 })
                                           .partial
                                     : mis.partial);
    if (partial > 0.0) {
      const EmissionPdf emission = light.emission_pdf(point, -flight.ray.direction);
      const double position =
          static_cast<double>(emission.position.value()) *
          static_cast<double>(scene_.light_sampler().emitter_probability(light).value());
      others += h(heuristic, position) *
                h(heuristic, static_cast<double>(emission.departure.value())) * partial;
    }
    return others / mean(h(heuristic, end.lanes));
  };
  const double weight = mis_weight(TechniqueClass::Implicit, others_of);
  sink.add({.value = flight.throughput * end.weight * emitted * static_cast<float>(weight),
            .technique = {0, edges + 1},
            .mis_weight = weight,
            .roulette_weight = flight.roulette,
            .unidirectional_only = flight.specular && !flight.has_rough_edge,
            .light_point = &point,
            .light = &light,
            .shares = shares_});
}

void PathSampler::connect_to_lights(const PathVertex& vertex, SampleSource& source,
                                    PathSink& sink) {
  if (scene_.light_sampler().empty()) return;
  const double count = settings_.techniques.count({1, vertex.edges + 1});
  const double whole = std::floor(count);
  int tries = static_cast<int>(whole);
  if (count > whole) {
    const Pair pair{0, vertex.edges, 0, vertex.surplus};
    const auto u = static_cast<double>(source.get(pair.address(kConnectionTry)));
    if (u < count - whole) ++tries;
  }
  for (int i = 0; i < tries; ++i) connect_to_light(vertex, source, i, sink);
}

void PathSampler::connect_to_light(const PathVertex& vertex, SampleSource& source, int repeat,
                                   PathSink& sink) {
  const Pair pair{0, vertex.edges, repeat, vertex.surplus};
  const auto address = [&](Slot slot) {
    return repeat == 0 ? SampleAddress(Stream::Camera, vertex.edges, slot) : pair.address(slot);
  };
  const LightSampler& lights = scene_.light_sampler();
  const ChosenLight chosen = lights.choose(vertex.p, source.get(address(Slot::LightChoice)));
  ConnectionUniforms u{};
  u.primitive = source.get(address(Slot::LightPrimitive));
  u.position = source.get_pair(address(Slot::LightPositionX));
  const Light& light = *chosen.light;
  const std::optional<ConnectionSample> sample = light.sample_connection(vertex.p, u);
  if (!sample) return;
  const Technique technique{1, vertex.edges + 1};
  const double own_count = count(technique);
  const float probability = chosen.probability.value();
  const BsdfValue scattered = vertex.evaluate(sample->w, TransportMode::Radiance);
  const Spectrum unoccluded = vertex.throughput * scattered.value * sample->weight /
                              (probability * static_cast<float>(own_count));
  if (unoccluded.is_black()) return;

  const auto weight_of = [&](const Segment& segment) {
    const Heuristic heuristic = settings_.heuristic;
    const double connection_density =
        static_cast<double>(sample->pdf.value()) * static_cast<double>(probability);
    const auto distance = static_cast<double>(sample->distance);
    const auto others_of = [&](OnlyClass only) {
      double others = 0.0;
      const double implicit = h_count({0, technique.t + 1}, only);
      if (implicit > 0.0 && !light.discrete_position()) {
        const double reverse = static_cast<double>(scattered.pdf.value()) *
                               endpoint_geometry(light, sample->point, sample->w, distance);
        const ByLane hits = vertex.lanes * by_lane(segment.distance_pdf()) * reverse;
        others += implicit * mean(h(heuristic, hits / connection_density));
      }
      if (settings_.techniques.needs_light_subpath()) {
        const EmissionPdf emission = light.emission_pdf(sample->point, -sample->w);
        const double position = static_cast<double>(emission.position.value()) *
                                static_cast<double>(lights.emitter_probability(light).value());
        const ByLane arrival = by_lane(segment.distance_pdf(vertex.scattered_in())) *
                               arrival_density(emission.departure, light.at_infinity(), distance,
                                               vertex.cosine(sample->w));
        others += h(heuristic, position / connection_density) *
                  mean(camera_mis(vertex, technique.depth(), only)
                           .sum(heuristic, arrival, vertex.pdf(sample->w, vertex.wo).value()));
      }
      return others / (h(heuristic, own_count) * mean(h(heuristic, vertex.lanes)));
    };
    return mis_weight(TechniqueClass::NextEvent, others_of);
  };
  const std::optional<Joined> joined =
      join(ray_to_endpoint(vertex, light, *sample), vertex.medium_toward(sample->w), unoccluded,
           rays_per_unit_light_, pair, source, weight_of);
  if (!joined) return;
  sink.add({.value = joined->value,
            .technique = technique,
            .mis_weight = joined->mis_weight,
            .roulette_weight = vertex.roulette * joined->culling,
            .light_point = &sample->point,
            .light = &light,
            .shares = shares_});
}

void PathSampler::connect_to_camera(const PathVertex& vertex, SampleSource& source,
                                    PathSink& sink) {
  const Pair pair{vertex.edges, 0, vertex.repeat, vertex.surplus};
  const Technique technique{vertex.edges + 1, 1};
  if (!is_tried(settings_.techniques.count(technique), pair, source)) return;
  const Camera& camera = scene_.camera();
  ConnectionUniforms u{};
  u.position = source.get_pair({Stream::Light, vertex.edges, Slot::LightPositionX, vertex.repeat});
  const std::optional<ConnectionSample> sample = camera.sample_connection(vertex.p, u);
  if (!sample) return;
  const std::optional<Vec2> raster = camera.raster(sample->point, -sample->w);
  if (!raster || !sink.reaches(*raster)) return;
  const BsdfValue scattered = vertex.evaluate(sample->w, TransportMode::Importance);
  const double own_count = count(technique);
  const Spectrum unoccluded =
      vertex.throughput * scattered.value * sample->weight / static_cast<float>(own_count);
  if (unoccluded.is_black()) return;

  const auto weight_of = [&](const Segment& segment) {
    // The camera looks through such a surface.
    if (vertex.on_light && scene_.hides_lights() && segment.counted_interfaces == 0) return 0.0;
    const EmissionPdf emission = camera.emission_pdf(sample->point, -sample->w);
    const Heuristic heuristic = settings_.heuristic;
    const ByLane arrival =
        by_lane(segment.distance_pdf(vertex.scattered_in())) *
        arrival_density(emission.departure, camera.at_infinity(),
                        static_cast<double>(sample->distance), vertex.cosine(sample->w));
    const double own = h(heuristic, own_count) * mean(h(heuristic, vertex.lanes));
    return mis_weight(TechniqueClass::Light, [&](OnlyClass only) {
      return mean(light_mis(vertex, technique.depth(), only)
                      .sum(heuristic, arrival, vertex.pdf(sample->w, vertex.wo).value())) /
             own;
    });
  };
  Ray ray = ray_to_endpoint(vertex, camera, *sample);
  ray.passes_lights = scene_.hides_lights();
  const std::optional<Joined> joined =
      join(ray, vertex.medium_toward(sample->w), unoccluded, sink.rays_per_unit_light(*raster),
           pair, source, weight_of);
  if (!joined) return;
  sink.add({.value = joined->value,
            .technique = technique,
            .mis_weight = joined->mis_weight,
            .roulette_weight = vertex.roulette * joined->culling,
            .light_subpath = vertex.repeat,
            .raster = *raster,
            .camera_point = &sample->point,
            .shares = shares_});
}

void PathSampler::connect_inner(const PathVertex& camera_vertex, const PathVertex& light_vertex,
                                SampleSource& source, PathSink& sink) {
  const Technique technique{light_vertex.edges + 1, camera_vertex.edges + 1};
  if (!wants(technique)) return;
  const Pair pair{light_vertex.edges, camera_vertex.edges, light_vertex.repeat,
                  light_vertex.surplus + camera_vertex.surplus};
  if (!is_tried(settings_.techniques.count(technique), pair, source)) return;
  const Vec3 difference = light_vertex.p - camera_vertex.p;
  const float distance_squared = length_squared(difference);
  if (distance_squared == 0.F) return;
  const float distance = std::sqrt(distance_squared);
  const Vec3 w = difference / distance;  // camera vertex → light vertex
  const BsdfValue at_camera_vertex = camera_vertex.evaluate(w, TransportMode::Radiance);
  if (at_camera_vertex.value.is_black()) return;
  const BsdfValue at_light_vertex = light_vertex.evaluate(-w, TransportMode::Importance);
  const double own_count = count(technique);
  // Density of both subpaths by one lane, over that with independent lanes.
  const auto together = static_cast<float>(mean(camera_vertex.lanes * light_vertex.lanes));
  if (together == 0.F) return;
  const Spectrum unoccluded = camera_vertex.throughput * light_vertex.throughput *
                              at_camera_vertex.value * at_light_vertex.value /
                              (distance_squared * static_cast<float>(own_count) * together);
  if (unoccluded.is_black()) return;

  const auto weight_of = [&](const Segment& segment) {
    const Heuristic heuristic = settings_.heuristic;
    const double inverse_square = 1.0 / static_cast<double>(distance_squared);
    const ByLane to_camera_vertex = by_lane(segment.distance_pdf(camera_vertex.scattered_in())) *
                                    (static_cast<double>(at_light_vertex.pdf.value()) *
                                     static_cast<double>(camera_vertex.cosine(w)) * inverse_square);
    const ByLane to_light_vertex = by_lane(segment.distance_pdf(light_vertex.scattered_in())) *
                                   (static_cast<double>(at_camera_vertex.pdf.value()) *
                                    static_cast<double>(light_vertex.cosine(w)) * inverse_square);
    const int depth = technique.depth();
    const double own =
        h(heuristic, own_count) * mean(h(heuristic, camera_vertex.lanes * light_vertex.lanes));
    return mis_weight(TechniqueClass::Inner, [&](OnlyClass only) {
      const ByLane others =
          h(heuristic, light_vertex.lanes) *
              camera_mis(camera_vertex, depth, only)
                  .sum(heuristic, to_camera_vertex,
                       camera_vertex.pdf(w, camera_vertex.wo).value()) +
          h(heuristic, camera_vertex.lanes) *
              light_mis(light_vertex, depth, only)
                  .sum(heuristic, to_light_vertex, light_vertex.pdf(-w, light_vertex.wo).value());
      return mean(others) / own;
    });
  };
  const std::optional<Joined> joined = join(
      ray_between(camera_vertex.ray_origin(w), light_vertex.ray_end(-w, distance)),
      camera_vertex.medium_toward(w), unoccluded, rays_per_unit_light_, pair, source, weight_of);
  if (!joined) return;
  sink.add({.value = joined->value,
            .technique = technique,
            .mis_weight = joined->mis_weight,
            .roulette_weight = camera_vertex.roulette * light_vertex.roulette * joined->culling,
            .light_subpath = light_vertex.repeat,
            .shares = shares_});
}

}  // namespace ajar
