#pragma once
#include <memory>
#include <vector>

#include "integrator/integrator.h"
#include "integrator/metropolis/path_group.h"

namespace ajar {

/// Metropolis light transport in primary sample space as published (docs/methods/pssmlt.md,
/// docs/methods/mmlt.md): `pssmlt` (Kelemen et al. 2002) and `mmlt` (Hachisuka, Kaplanyan &
/// Dachsbacher 2014), the baseline that papers compare with. Markov chains make all light.
std::vector<ParameterSpec> metropolis_parameters(ChainSpace kind);

/// `part` of the light of long paths is the chains' if it is not null, and must outlive them.
/// Raises UsageError for parameters that cannot be used.
std::unique_ptr<Integrator> make_metropolis_integrator(ChainSpace kind, const Scene& scene,
                                                       const RenderSettings& settings,
                                                       const Parameters& parameters,
                                                       const ChainWeight* part = nullptr);

}  // namespace ajar
