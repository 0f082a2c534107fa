#pragma once
#include "integrator/integrator.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Parameters that all members of the family share; they differ in the default of `techniques`.
std::vector<ParameterSpec> path_family_parameters(const std::string& techniques);

/// Ordinary Monte Carlo with one set of techniques (METHODS, section 2): `pt`, `lt`, `ibpt`, `bdpt`
/// are four names of it. Raises UsageError if the parameter `techniques` cannot be read.
std::unique_ptr<Integrator> make_path_integrator(const Scene& scene, const RenderSettings& settings,
                                                 const Parameters& parameters);

}  // namespace ajar
