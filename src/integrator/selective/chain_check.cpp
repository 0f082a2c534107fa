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

void check_population(const ChainPopulation& population, const ChainPlan& plan,
                      std::uint64_t samples) {
  const auto replicates = static_cast<std::uint64_t>(plan.settings.replicates);
  // A pass that was cut short may have come as far as this; each sample has a step at least.
  const auto passes = static_cast<double>(milestone_after(samples, replicates));
  const double most_steps =
      passes * (1.0 + std::max(plan.mutations, SelectiveHeuristics::kMostMutations) *
                          static_cast<double>(plan.pixels()));
  const PathGroup& group = plan.groups[population.group];
  check_record(population.retired, group, moves_of(group).size());
  check_record({population.plain_statistics, {}}, group);
  constexpr double kMostSamples = 0x1p63;
  require(population.samples_behind >= 0.0 && population.samples_behind < kMostSamples,
          "chains stand for samples that cannot be");
  if (const auto& joined = population.joined) {
    require(is_sum(joined->b) && is_sum(joined->variance) && is_sum(joined->of_recruits) &&
                is_sum(joined->of_chains) && (joined->b > 0.0 || population.chains.empty()),
            "the brightness of chains cannot be");
  }
  parallel_for(population.chains.size(), [&](std::size_t i) {
    check_chain(plan, population, population.chains[i], most_steps);
  });
}

}  // namespace ajar
