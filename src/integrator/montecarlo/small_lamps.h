#pragma once
#include <span>

#include "scene/scene.h"
#include "transport/path_vertex.h"

namespace ajar {

/// Where light of a lamp that has an extent leaves clear glass or mirrors for something that
/// scatters it.
struct Landing {
  const Endpoint* lamp;
  PathVertex vertex;  ///< vertex of a light subpath whose vertices before are all clear
};

/// Number of landings, of that many light subpaths, that belong to lamps as good as points: of the
/// rays that leave such landings at random and meet nothing but clear surfaces on their way, fewer
/// than `MonteCarloHeuristics::kRarelyMet` run into the lamp. Camera paths find such light about as
/// rarely, and replicates without it agree. Lamps whose landings are less than `kLightOfSmallLamps`
/// of the light do not count. Deterministic for a seed; traces up to `kRaysBack` paths.
std::size_t landings_of_small_lamps(const Scene& scene, std::span<const Landing> landings,
                                    int light_paths, int max_depth, std::uint64_t seed);

}  // namespace ajar
