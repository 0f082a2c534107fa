#pragma once
#include <memory>
#include <vector>

#include "integrator/integrator.h"

namespace ajar {

/// Energy redistribution path tracing (docs/methods/mlt.md): independent samples, what each of them
/// brings spread over short chains that start from it. Source: Cline, Talbot & Egbert 2005.
std::vector<ParameterSpec> erpt_parameters();

/// Raises UsageError for parameters that cannot be used.
std::unique_ptr<Integrator> make_erpt_integrator(const Scene& scene, const RenderSettings& settings,
                                                 const Parameters& parameters);

}  // namespace ajar
