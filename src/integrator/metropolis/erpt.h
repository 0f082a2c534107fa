#pragma once
#include <memory>
#include <vector>

#include "integrator/chain_weight.h"
#include "integrator/integrator.h"

namespace ajar {

/// Energy redistribution path tracing (docs/methods/mlt.md): independent samples, what each of them
/// brings spread over short chains that start from it. Source: Cline, Talbot & Egbert 2005.
std::vector<ParameterSpec> erpt_parameters();

/// `part` of the light of long paths is the chains' if it is not null, and must outlive them.
/// Raises UsageError for parameters that cannot be used.
std::unique_ptr<Integrator> make_erpt_integrator(const Scene& scene, const RenderSettings& settings,
                                                 const Parameters& parameters,
                                                 const ChainWeight* part = nullptr);

}  // namespace ajar
