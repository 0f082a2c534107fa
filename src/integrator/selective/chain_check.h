#pragma once
#include <cstdint>

#include "integrator/selective/chain_population.h"
#include "integrator/selective/preparation.h"

namespace ajar {

/// Checks that chains can have come out of a render like this after `samples` samples per pixel,
/// so that they can go on: also whether each is at a state that its target knows. Raises
/// std::runtime_error. For what is read from an archive.
void check_population(const ChainPopulation& population, const SelectivePreparation& prepared,
                      std::uint64_t samples);

}  // namespace ajar
