#include <algorithm>

#include "transport/heuristics.h"
#include "transport/path_sampler.h"

namespace ajar {

bool PathSampler::sample_vertex(const PathVertex& vertex, std::uint32_t cell, SampleSource& source,
                                PathSink& sink, Flight& flight) {
  const EfficiencyCells::Worth& worth = settings_.cells->worth(cell);
  const WorthOfDirection in_rays = {worth.rest[0] * rays_per_unit_light_,
                                    worth.rest[1] * rays_per_unit_light_};
  if (!learns_) {
    connect_to_lamps(vertex, source, sink);
    return depart(vertex, in_rays, source, sink, flight);
  }
  Departure departure{.cell = cell,
                      .arrived_with = vertex.throughput.max(),
                      .brought_before = sink.brought(),
                      .rays_before = rays_.rays};
  connect_to_lamps(vertex, source, sink);
  departure.brought_there = sink.brought();
  departure.rays_there = rays_.rays;
  const bool leaves = depart(vertex, in_rays, source, sink, flight);
  if (leaves) {
    departure.specular = flight.specular;
    departure.left_with = flight.throughput.max();
  }
  departures_.push_back(departure);
  return leaves;
}

bool PathSampler::split(const PathVertex& vertex, std::uint32_t cell, const Flight& flight,
                        SampleSource& source, PathSink& sink) {
  if (!settings_.splits || branches_.full()) return false;
  const float worth = TransportHeuristics::kSpreadOfVertex * vertex.throughput.max() *
                      settings_.cells->worth(cell).whole * rays_per_unit_light_;
  // A whole number, so that no chance is in the weights.
  const auto most = static_cast<float>(TransportHeuristics::kMostPaths / branches_.paths());
  const int samples = static_cast<int>(std::min(worth + 0.5F, most));
  if (samples < 2) return false;
  PathVertex own = vertex;
  own.throughput /= static_cast<float>(samples);
  own.roulette /= static_cast<float>(samples);
  for (int i = 0; i < samples; ++i) {
    branches_.enter(vertex.edges, i, samples);
    source.set_branches(branches_);
    Flight branch = flight;
    branch.roulette = own.roulette;
    const std::size_t first = departures_.size();
    if (sample_vertex(own, cell, source, sink, branch)) {
      follow_camera(branch, source, sink);
    }
    learn(first, sink);
    branches_.leave();
  }
  source.set_branches(branches_);
  return true;
}

bool PathSampler::depart_from(const PathVertex& vertex, SampleSource& source, const PathSink& sink,
                              Flight& flight) {
  if (settings_.light_cells == nullptr) return scatter(light_walk_, vertex, source, flight);
  const std::uint32_t cell = settings_.light_cells->find(vertex);
  const EfficiencyCells::Worth& worth = settings_.light_cells->worth(cell);
  if (!scatter(light_walk_, vertex, source, flight,
               {worth.rest[0] * flight.roulette_scale, worth.rest[1] * flight.roulette_scale})) {
    return false;
  }
  if (learns_of_light_) {
    light_departures_.push_back({.cell = cell,
                                 .specular = flight.specular,
                                 .left_with = flight.throughput.max() * flight.roulette_scale,
                                 .first_vertex = light_vertex_count_,
                                 .brought = sink.brought_to_lens(),
                                 .rays = rays_.rays});
  }
  return true;
}

void PathSampler::learn_of_light() {
  for (const LightDeparture& from : light_departures_) {
    double brought = from.brought;
    std::uint64_t rays = from.rays;
    for (std::size_t i = from.first_vertex; i < from.end_vertex; ++i) {
      brought += inner_connections_[i].brought;
      rays += inner_connections_[i].rays;
    }
    settings_.light_cells->add_rest(from.cell, from.specular,
                                    brought / static_cast<double>(from.left_with), rays);
  }
  light_departures_.clear();
}

void PathSampler::learn(std::size_t first, const PathSink& sink) {
  if (departures_.size() == first) return;
  const double brought = sink.brought();
  EfficiencyCells& cells = *settings_.cells;
  for (std::size_t i = first; i < departures_.size(); ++i) {
    const Departure& from = departures_[i];
    cells.add_whole(from.cell,
                    (brought - from.brought_before) / static_cast<double>(from.arrived_with),
                    rays_.rays - from.rays_before);
    if (!(from.left_with > 0.F)) continue;
    cells.add_rest(from.cell, from.specular,
                   (brought - from.brought_there) / static_cast<double>(from.left_with),
                   rays_.rays - from.rays_there);
  }
  departures_.resize(first);
}

}  // namespace ajar
