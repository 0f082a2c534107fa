#include "integrator/selective/chain_bootstrap.h"

#include <algorithm>

#include "integrator/selective/chain_starts.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

double ChainBootstrap::effort() const {
  // Else what the pilots find starts them.
  if (plan_.has_recruits() && !plan_.is_black) return 0.0;
  return SelectiveHeuristics::kEffortOfOnePath * static_cast<double>(plan_.bootstrap) /
         static_cast<double>(plan_.pixels());
}

std::uint64_t ChainBootstrap::begin() {
  // The pilot may have found seeds already.
  if (!populations_.empty() || plan_.mutations == 0.0) return 0;
  populations_ = make_populations(plan_);
  blocks_ = share_bootstrap(populations_, plan_.groups, plan_.settings.replicates, plan_.bootstrap);
  return blocks_.size();
}

void ChainBootstrap::run(std::uint64_t item, Counters& counters) {
  ChainPopulation& population = populations_[blocks_[item].owner];
  const auto target = plan_.make_seed_target(plan_.groups[population.group], population.replicate);
  sample_bootstrap(population, blocks_[item], *target, counters);
}

void ChainBootstrap::end() {
  if (blocks_.empty()) return;
  for (ChainPopulation& population : populations_) {
    for (const double weight : population.weights) {
      const double capped = std::min(weight, plan_.moves.settings.large_step_cap);
      population.capped.add(capped);
      population.excess.add(weight - capped);
    }
  }
  share_chains(
      populations_, plan_.groups, plan_.chains_per_replicate(),
      [](const ChainPopulation& population) { return population.b(0.0); },
      [&](ChainPopulation& population, std::size_t count) {
        population.chains = seed_chains_of(plan_, population, count);
      });
}

}  // namespace ajar
