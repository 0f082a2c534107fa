#pragma once
#include <vector>

#include "core/warnings.h"
#include "integrator/integrator.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Light that the techniques of a method cannot sample in a scene, however long it renders: paths
/// of depths that none of them makes, and those out of their reach among a few thousand samples.
/// Empty if there is none. `joins_by_manifolds`: the method has chains that start from manifold
/// connections (`PathSeeds`), which make paths beyond all techniques.
std::vector<Warning> blind_spots(const Scene& scene, const RenderSettings& settings,
                                 const PathSamplerSettings& sampler,
                                 bool joins_by_manifolds = false);

}  // namespace ajar
