#include "integrator/selective/chain_check.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/milestones.h"
#include "core/parallel_for.h"
#include "integrator/selective/chain_starts.h"
#include "integrator/selective/chain_walker.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

namespace {

void require(bool holds, const char* otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

bool is_sum(double value) { return value >= 0.0 && std::isfinite(value); }

}  // namespace

void check_population(const ChainPopulation& population, const SelectivePreparation& prepared,
                      std::uint64_t samples) {
  const auto replicates = static_cast<std::uint64_t>(prepared.config.settings.replicates);
  // A pass that was cut short may have come as far as this; each sample has a step at least.
  const auto passes = static_cast<double>(milestone_after(samples, replicates));
  const double most_steps = passes * (1.0 + std::max(prepared.mutations, kMostMutations) *
                                                static_cast<double>(prepared.pixels()));
  const PathGroup& group = prepared.groups()[population.group];
  check_record(population.retired, group, moves_of(group).size());
  constexpr double kMostSamples = 0x1p63;
  require(population.samples_behind >= 0.0 && population.samples_behind < kMostSamples,
          "corrupt checkpoint: invalid sample count");
  const ChainPopulation::Brightness& b = population.b;
  require(is_sum(b.total) && is_sum(b.variance) && is_sum(b.per_seed) && is_sum(b.of_chains) &&
              (b.total > 0.0 || population.chains.empty()),
          "corrupt checkpoint: invalid brightness of chains");
  parallel_for(population.chains.size(), [&](std::size_t i) {
    check_chain(prepared, population, population.chains[i], most_steps);
  });
}

}  // namespace ajar
