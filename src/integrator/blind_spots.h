#pragma once
#include <string>
#include <vector>

#include "integrator/integrator.h"
#include "transport/path_sampler.h"

namespace ajar {

/// What the techniques of an integrator of `path_family.h` cannot see in a scene, however long it
/// renders; one sentence each. From a few thousand samples; empty if these meet nothing of it.
std::vector<std::string> blind_spots(const Scene& scene, const RenderSettings& settings,
                                     const PathSamplerSettings& sampler);

}  // namespace ajar
