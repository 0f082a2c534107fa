#pragma once
#include "integrator/integrator.h"
#include "integrator/metropolis/path_group.h"
#include "integrator/selective/selective_settings.h"

namespace ajar {

std::vector<ParameterSpec> chain_parameters(ChainKind kind);

/// Metropolis light transport in primary sample space (docs/methods/divided-light.md): paths of up
/// to two edges by ordinary Monte Carlo, longer ones by Markov chains, many and independent, on
/// every replicate's own bootstrap. With `selective`, regions of the picture are divided between
/// both (docs/methods/selective.md), and samples are camera samples. Raises UsageError for
/// parameters that cannot be used.
std::unique_ptr<Integrator> make_chain_integrator(ChainKind kind, const Scene& scene,
                                                  const RenderSettings& settings,
                                                  const Parameters& parameters,
                                                  std::optional<SelectiveSettings> selective = {});

}  // namespace ajar
