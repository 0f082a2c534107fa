#include "integrator/montecarlo/small_lamps.h"

#include <algorithm>
#include <limits>
#include <map>

#include "integrator/montecarlo/clear_vertex.h"
#include "integrator/montecarlo/heuristics.h"
#include "transport/sources.h"
#include "transport/subpath.h"

namespace ajar {

namespace {

/// True if a ray that leaves `vertex` at random comes to `lamp` through specular surfaces alone.
bool comes_to(const Endpoint& lamp, const Scene& scene, PathVertex vertex, int max_depth,
              SampleSource& source) {
  const WalkSettings walk{.mode = TransportMode::Radiance,
                          .stream = Stream::Camera,
                          .heuristic = Heuristic::Balance,
                          .roulette_start = std::numeric_limits<int>::max(),
                          .has_other_end = false};
  RayCounts rays;
  Flight flight;
  while (vertex.edges < max_depth && scatter(walk, vertex, source, flight)) {
    const SegmentEnd end = trace_segment(scene, flight.ray, flight.medium, kAnyLane,
                                         {source, Stream::Camera, flight.edges, 0}, rays);
    if (end.scattered || end.lost) return false;
    if (!end.hit) {
      const auto around = scene.infinite_lights();
      return std::any_of(around.begin(), around.end(),
                         [&](const Light* light) { return light == &lamp; });
    }
    if (end.hit->light == &lamp) return true;
    arrive(walk, flight, end, 0.0, vertex);
    if (!is_clear(vertex)) return false;
  }
  return false;
}

struct Rays {
  std::size_t landings = 0;
  std::size_t tried = 0;
  std::size_t met = 0;
};

}  // namespace

std::size_t landings_of_small_lamps(const Scene& scene, std::span<const Landing> landings,
                                    int light_paths, int max_depth, std::uint64_t seed) {
  std::map<const Endpoint*, Rays> lamps;
  std::uint32_t index = 0;
  for (const Landing& landing : landings) {
    Rays& rays = lamps[landing.lamp];
    ++rays.landings;
    for (std::size_t i = 0; i < MonteCarloHeuristics::kRaysBack / landings.size(); ++i, ++index) {
      IndependentSource source({seed, index, seed, index});
      ++rays.tried;
      if (comes_to(*landing.lamp, scene, landing.vertex, max_depth, source)) ++rays.met;
    }
  }
  std::size_t count = 0;
  for (const auto& [lamp, rays] : lamps) {
    const bool matters = static_cast<double>(rays.landings) >=
                         MonteCarloHeuristics::kLightOfSmallLamps * light_paths;
    const bool is_small = static_cast<double>(rays.met) <
                          MonteCarloHeuristics::kRarelyMet * static_cast<double>(rays.tried);
    if (matters && is_small) count += rays.landings;
  }
  return count;
}

}  // namespace ajar
