#pragma once
#include <memory>
#include <vector>

#include "integrator/integrator.h"

namespace ajar {

/// Metropolis light transport in path space (docs/methods/mlt.md): chains whose states are explicit
/// paths. Source: Veach & Guibas 1997; Veach 1997, chapter 11.
std::vector<ParameterSpec> mlt_parameters();

/// Raises UsageError for parameters that cannot be used.
std::unique_ptr<Integrator> make_mlt_integrator(const Scene& scene, const RenderSettings& settings,
                                                const Parameters& parameters);

}  // namespace ajar
