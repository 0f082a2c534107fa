#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "integrator/selective/chain_population.h"
#include "integrator/selective/path_numbers.h"
#include "integrator/selective/preparation.h"

/// Starts of chains of any kind.
namespace ajar {

/// A chain at a path that ordinary Monte Carlo has found; empty if chains cannot be there.
/// `known`: I if already evaluated; else evaluated here, may be 0, at the cost of `rays`.
std::optional<SelectiveChain> start_chain_of(const SelectivePreparation& prepared,
                                             const PathNumbers& numbers, const OutlierPath& found,
                                             std::optional<double> known, RayCounts& rays);

/// A chain of explicit paths, which starts from this one.
SelectiveChain start_chain_at(const Path& path, std::uint64_t seed);

/// Raises std::runtime_error unless a chain of a population can be as it is: after at most
/// `most_steps` steps, at a state that its target knows, too.
void check_chain(const SelectivePreparation& prepared, const ChainPopulation& population,
                 const SelectiveChain& chain, double most_steps);

}  // namespace ajar
