#pragma once
#include <vector>

#include "core/warnings.h"
#include "integrator/integrator.h"
#include "transport/path_sampler.h"

namespace ajar {

/// What the techniques of an integrator of `path_family.h` cannot see in a scene, however long it
/// renders. From a few thousand samples; empty if these meet nothing of it.
std::vector<Warning> blind_spots(const Scene& scene, const RenderSettings& settings,
                                 const PathSamplerSettings& sampler);

}  // namespace ajar
