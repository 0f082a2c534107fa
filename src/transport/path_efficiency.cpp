#include <algorithm>
#include <limits>

#include "transport/heuristics.h"
#include "transport/path_sampler.h"

namespace ajar {

void PathSampler::learn(const PathSink& sink) {
  const double most =
      knows_price_ ? TransportHeuristics::kMostRays / static_cast<double>(rays_per_unit_light_)
                   : std::numeric_limits<double>::infinity();
  for (const Departure& from : departures_) {
    settings_.cells->add(
        from.cell, from.specular,
        std::min(most, sink.brought() - from.brought) / static_cast<double>(from.left_with),
        rays_.rays - from.rays);
  }
  departures_.clear();
}

bool PathSampler::depart_from_light(const PathVertex& vertex, SampleSource& source,
                                    const PathSink& sink, Flight& flight) {
  if (settings_.light_cells == nullptr) return scatter(light_walk_, vertex, source, flight);
  const std::uint32_t cell = settings_.light_cells->find(vertex);
  const EfficiencyCells::Worth& worth = settings_.light_cells->worth(cell);
  if (!scatter(light_walk_, vertex, source, flight,
               {worth[0] * flight.roulette_scale, worth[1] * flight.roulette_scale})) {
    return false;
  }
  if (learns_ && knows_price_) {
    light_departures_.push_back({{.cell = cell,
                                  .specular = flight.specular,
                                  .left_with = flight.throughput.max() * flight.roulette_scale,
                                  .brought = sink.brought_to_lens(),
                                  .rays = rays_.rays},
                                 light_vertex_count_});
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
    settings_.light_cells->add(
        from.cell, from.specular,
        std::min(brought, TransportHeuristics::kMostRays) / static_cast<double>(from.left_with),
        rays);
  }
  light_departures_.clear();
}

}  // namespace ajar
