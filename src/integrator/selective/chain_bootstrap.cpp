#include "integrator/selective/chain_bootstrap.h"

#include <algorithm>

#include "core/random.h"
#include "core/random_use.h"
#include "mcmc/bootstrap.h"

namespace ajar {

std::vector<ChainPopulation> make_populations(const ChainPlan& plan) {
  std::vector<ChainPopulation> populations;
  for (int replicate = 0; replicate < plan.settings.replicates; ++replicate) {
    for (std::size_t g = 0; g < plan.groups.size(); ++g) {
      ChainPopulation population;
      population.group = g;
      population.replicate = replicate;
      population.seed =
          hash_numbers(plan.settings.seed, RandomUse::Bootstrap, replicate, plan.groups[g].depth);
      populations.push_back(std::move(population));
    }
  }
  return populations;
}

double ChainBootstrap::effort() const {
  if (plan_.has_recruits()) return 0.0;
  // One technique of a path has about half the rays of all of them.
  constexpr double kOfCameraSample = 0.5;
  return kOfCameraSample * static_cast<double>(plan_.bootstrap) /
         static_cast<double>(plan_.pixels());
}

std::uint64_t ChainBootstrap::begin() {
  // The pilot may have found seeds already.
  if (!populations_.empty() || plan_.mutations == 0.0) return 0;
  constexpr double kFewest = 64.0;
  const double per_replicate = static_cast<double>(plan_.bootstrap) / plan_.settings.replicates;
  populations_ = make_populations(plan_);
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    const double samples =
        std::max(kFewest, per_replicate * bootstrap_share(plan_.groups, populations_[p].group));
    populations_[p].weights.resize(static_cast<std::size_t>(samples));
    add_blocks(blocks_, p, populations_[p].weights.size());
  }
  return blocks_.size();
}

void ChainBootstrap::run(std::uint64_t item, Counters& counters) {
  const SampleBlock& block = blocks_[item];
  ChainPopulation& population = populations_[block.owner];
  const auto target = plan_.make_target(plan_.groups[population.group], population.replicate);
  sample_bootstrap(*target, population.seed, block.first, block.last,
                   std::span(population.weights).subspan(block.first));
  counters.add_rays(target->ray_counts());
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
  for (int r = 0; r < plan_.settings.replicates; ++r) seed_replicate(r);
  for (ChainPopulation& population : populations_) population.weights = {};
}

void ChainBootstrap::seed_replicate(int replicate) {
  std::vector<ChainPopulation*> own;
  std::vector<double> b;
  for (ChainPopulation& population : populations_) {
    if (population.replicate != replicate) continue;
    own.push_back(&population);
    b.push_back(population.b(0.0));
  }
  const std::vector<std::size_t> shares = apportion(b, plan_.chains_per_replicate());
  for (std::size_t i = 0; i < own.size(); ++i) {
    ChainPopulation& population = *own[i];
    population.chains = seed_chains(plan_.groups[population.group], population.seed,
                                    population.weights, shares[i], plan_.seed_rule);
  }
}

}  // namespace ajar
