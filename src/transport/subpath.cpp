#include "transport/subpath.h"

#include <algorithm>

#include "transport/heuristics.h"

namespace ajar {

MisStep mis_step(const Flight& flight, const Segment& segment, float distance, float cosine_at_end,
                 const MediumPoint& end, bool at_infinity, double class_coefficient) {
  // Scattering events of a medium can fall on the very float coordinates of the vertex before.
  const double apart = std::max(static_cast<double>(distance), 1e-18);
  const double inverse_square = at_infinity ? 1.0 : 1.0 / (apart * apart);
  // A ray from infinity is spread over area, not over solid angle: no inverse square on arrival,
  // and a vertex at infinity measures directions, so none on the way back either.
  const double forward_geometry = flight.from_infinity || at_infinity ? 1.0 : inverse_square;
  MisStep step{};
  step.specular = flight.specular;
  step.reverse_previous = flight.reverse_previous;
  step.forward = static_cast<double>(flight.departure) * forward_geometry *
                 (at_infinity ? 1.0 : static_cast<double>(cosine_at_end)) *
                 mean(flight.lanes * by_lane(segment.distance_pdf(end)));
  step.lanes = flight.lanes;
  step.backward_geometry =
      flight.from_infinity
          ? by_lane(segment.distance_pdf())
          : by_lane(segment.distance_pdf({flight.scattered_in, flight.reference})) *
                (static_cast<double>(flight.cosine) * inverse_square);
  step.class_coefficient = class_coefficient;
  return step;
}

std::optional<EmissionSample> camera_ray(const Camera& camera, SampleSource& source,
                                         const Vec2& raster) {
  const Vec2 size(camera.resolution());
  EmissionUniforms u{};
  u.position = source.get_pair({Stream::Camera, 0, kEmissionPosition});
  u.direction = {raster.x / size.x, raster.y / size.y};
  return camera.sample_emission(u);
}

void arrive(const WalkSettings& settings, const Flight& flight, const SegmentEnd& end,
            double class_coefficient, PathVertex& vertex) {
  vertex.wo = -flight.ray.direction;
  vertex.throughput = flight.throughput * end.weight;
  vertex.lanes = end.lanes;
  vertex.roulette = flight.roulette;
  vertex.medium = end.medium;
  vertex.edges = flight.edges + 1;
  vertex.surplus = flight.surplus + end.segment.counted_interfaces;
  vertex.repeat = settings.repeat;
  vertex.in_medium = end.scattered;
  vertex.on_light = end.hit && end.hit->light != nullptr;
  if (end.scattered) {
    vertex.p = flight.ray.origin + flight.ray.direction * end.distance;
    vertex.media = nullptr;
  } else {
    vertex.p = end.hit->point.p;
    vertex.media = end.hit->media;
    end.hit->material->bsdf(end.hit->point, vertex.bsdf);
  }
  if (!settings.has_other_end && (end.scattered || end.hit->light == nullptr)) return;
  // Between the vertices themselves, as connections measure it; the ray started a little off the
  // surface.
  const float distance = flight.from_infinity ? end.distance : length(vertex.p - flight.reference);
  const MisStep step = mis_step(flight, end.segment, distance, vertex.cosine(vertex.wo),
                                vertex.scattered_in(), false, class_coefficient);
  vertex.mis = mis_extend(settings.heuristic, flight.mis, step);
  if (settings.trail != nullptr) {
    settings.trail[vertex.edges] = mis_trail_entry(settings.heuristic, vertex.mis, step);
    vertex.trail = settings.trail;
  }
}

bool scatter(const WalkSettings& settings, const PathVertex& vertex, SampleSource& source,
             Flight& flight, const WorthOfDirection& worth) {
  BsdfUniforms u{};
  const auto address = [&](Slot slot) {
    return SampleAddress(settings.stream, vertex.edges, slot, settings.repeat);
  };
  u.lobe = source.get(address(Slot::BsdfLobe));
  if (settings.directions != nullptr) {
    settings.directions->place(vertex, u.lobe, address(Slot::BsdfDirectionX), source);
  }
  u.direction = source.get_pair(address(Slot::BsdfDirectionX));
  const std::optional<BsdfSample> sample =
      vertex.sample(u, settings.mode, settings.has_other_end ? Reverse::Compute : Reverse::Skip);
  if (!sample) return false;
  if (settings.directions != nullptr) settings.directions->note(vertex, u.lobe, sample->wi);
  flight.throughput = vertex.throughput * sample->weight;
  flight.lanes = vertex.lanes;
  if (settings.mode == TransportMode::Radiance) flight.roulette_scale *= sample->eta * sample->eta;
  const float own_worth = worth[sample->pdf.discrete() ? 1 : 0];
  const bool is_long = vertex.edges >= settings.roulette_start;
  if (is_long || own_worth > 0.F) {
    const float survival = std::min(
        is_long ? 0.95F : 1.F, own_worth > 0.F ? std::max(TransportHeuristics::kLeastSurvival,
                                                          flight.throughput.max() * own_worth)
                                               : flight.throughput.max() * flight.roulette_scale);
    if (survival != 1.F) {
      if (!(source.get(address(Slot::Roulette)) < survival)) return false;
      flight.throughput /= survival;
      flight.roulette /= survival;
    }
  }
  if (flight.throughput.is_black()) return false;
  const bool uncounted =
      sample->transmission && sample->pdf.discrete() && vertex.bsdf.is_uncounted(sample->event());
  // Vertices that do not count are none to a camera that looks past lights.
  const bool passes_lights =
      flight.ray.passes_lights && uncounted && vertex.surplus == flight.surplus;
  flight.surplus = vertex.surplus - (uncounted ? 1 : 0);
  flight.ray = {vertex.ray_origin(sample->wi), sample->wi};
  flight.ray.passes_lights = passes_lights;
  flight.medium = vertex.medium_toward(sample->wi);
  flight.reference = vertex.p;
  flight.edges = vertex.edges;
  flight.mis = vertex.mis;
  flight.departure = sample->pdf.value();
  flight.from_infinity = false;
  const bool specular = sample->pdf.discrete();
  flight.has_rough_edge = flight.has_rough_edge || (!flight.specular && !specular);
  flight.specular = specular;
  flight.event = sample->event();
  flight.reverse_previous = sample->reverse_pdf.value();
  flight.cosine = vertex.cosine(sample->wi);
  flight.scattered_in = vertex.in_medium ? vertex.medium : nullptr;
  return true;
}

}  // namespace ajar
