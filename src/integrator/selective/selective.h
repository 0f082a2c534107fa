#pragma once
#include "integrator/integrator.h"

namespace ajar {

std::vector<ParameterSpec> selective_parameters();

/// Ordinary Monte Carlo where it works, Markov chains where it fails (`selective`). A sample is a
/// camera sample; chains make as many mutations with it as their share of the light deserves, or
/// none at all. `parameters` as `IntegratorInfo::read` has them, presets included.
std::unique_ptr<Integrator> make_selective_integrator(const Scene& scene,
                                                      const RenderSettings& settings,
                                                      const Parameters& parameters);

}  // namespace ajar
