#pragma once
#include "integrator/integrator.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Parameters that all members of the family share.
std::vector<ParameterSpec> path_family_parameters();

/// Ordinary Monte Carlo with one set of techniques (METHODS, section 2): `pt`, `lt`, `ibpt`, `bdpt`
/// are four constants of it.
std::unique_ptr<Integrator> make_path_integrator(TechniqueSet techniques, const Scene& scene,
                                                 const RenderSettings& settings,
                                                 const Parameters& parameters);

}  // namespace ajar
