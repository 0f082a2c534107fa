#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_population.h"
#include "integrator/selective/path_numbers.h"

/// Where chains begin, of any kind.
namespace ajar {

/// `count` chains at samples of a population's bootstrap, in proportion to I.
std::vector<SelectiveChain> seed_chains_of(const ChainPlan& plan, const ChainPopulation& population,
                                           std::size_t count);

/// A chain at what ordinary Monte Carlo has found. Its I is `known`, or what the target says, which
/// may be nothing a chain can go on with. Empty if chains cannot be there at all. `rays` is told
/// what it takes.
std::optional<SelectiveChain> start_chain_of(const ChainPlan& plan, const PathNumbers& numbers,
                                             const StrongPath& found, std::optional<double> known,
                                             RayCounts& rays);

/// A chain of explicit paths, which starts from this one.
SelectiveChain start_chain_at(const Path& path, std::uint64_t seed);

/// Raises std::runtime_error unless a chain of a population can be as it is: after at most
/// `most_steps` steps, at a state that its target knows, too.
void check_chain(const ChainPlan& plan, const ChainPopulation& population,
                 const SelectiveChain& chain, double most_steps);

}  // namespace ajar
