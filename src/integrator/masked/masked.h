#pragma once
#include <memory>
#include <vector>

#include "integrator/integrator.h"

namespace ajar {

/// Selective Metropolis light transport as published (docs/methods/masked.md): a mask of the
/// picture's regions says where Markov chains make indirect light and where ordinary Monte Carlo
/// does. A sample per pixel is a camera sample, and `mutations` mutations per pixel. Source:
/// V. A. Frolov, "Selective application of Metropolis Light Transport for hard sampling
/// illumination phenomena".
std::vector<ParameterSpec> masked_parameters();

/// Raises UsageError for parameters that cannot be used, SceneError or IoError for `regions`.
std::unique_ptr<Integrator> make_masked_integrator(const Scene& scene,
                                                   const RenderSettings& settings,
                                                   const Parameters& parameters);

}  // namespace ajar
