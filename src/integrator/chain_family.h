#pragma once
#include "integrator/integrator.h"

namespace ajar {

/// How `selective` differs from `mmlt`: a sample is a camera sample, and the number of mutations
/// that go with it follows from a survey of the scene.
struct Selection {};

/// How the states of a chain are made of paths.
enum class ChainKind {
  WholePath,  ///< `pssmlt`: a camera and a light subpath with all their connections
  OnePath     ///< `mmlt`: one path of one depth and technique
};

std::vector<ParameterSpec> chain_parameters(ChainKind kind);

/// Metropolis light transport in primary sample space (METHODS, section 3): paths of up to two
/// edges by ordinary Monte Carlo, longer ones by Markov chains, many and independent, on every
/// replicate's own bootstrap. Raises UsageError for parameters that cannot be used.
std::unique_ptr<Integrator> make_chain_integrator(ChainKind kind, const Scene& scene,
                                                  const RenderSettings& settings,
                                                  const Parameters& parameters,
                                                  std::optional<Selection> selection = {});

}  // namespace ajar
