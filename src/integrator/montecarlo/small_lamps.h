#pragma once
#include <span>

#include "scene/scene.h"
#include "transport/path_vertex.h"

namespace ajar {

/// Where light of a lamp that has an extent leaves clear glass or mirrors for something that
/// scatters it.
struct Landing {
  const Endpoint* lamp;
  PathVertex vertex;  ///< of a light subpath whose vertices before this one are all clear
};

/// How many of the landings, which that many light subpaths made, belong to lamps that are as good
/// as points: of the rays that leave such landings at random and meet nothing but clear things on
/// their way, fewer than `MonteCarloHeuristics::kRarelyMet` run into the lamp. A camera path finds
/// light of that kind about as rarely, and replicates that have never met it agree. Lamps whose
/// landings are less than `kLightOfSmallLamps` of the light do not count. Deterministic for a seed;
/// traces up to `kRaysBack` paths.
std::size_t landings_of_small_lamps(const Scene& scene, std::span<const Landing> landings,
                                    int light_paths, int max_depth, std::uint64_t seed);

}  // namespace ajar
