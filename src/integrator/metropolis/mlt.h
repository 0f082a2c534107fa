#pragma once
#include <memory>
#include <vector>

#include "integrator/chain_weight.h"
#include "integrator/integrator.h"

namespace ajar {

/// Metropolis light transport in path space (docs/methods/mlt.md): chains whose states are explicit
/// paths. Source: Veach & Guibas 1997; Veach 1997, chapter 11.
std::vector<ParameterSpec> mlt_parameters();

/// `part` of the light of long paths is the chains' if it is not null, and must outlive them.
/// Raises UsageError for parameters that cannot be used.
std::unique_ptr<Integrator> make_mlt_integrator(const Scene& scene, const RenderSettings& settings,
                                                const Parameters& parameters,
                                                const ChainWeight* part = nullptr);

}  // namespace ajar
