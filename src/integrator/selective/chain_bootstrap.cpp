#include "integrator/selective/chain_bootstrap.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "mcmc/bootstrap.h"
#include "mcmc/primary/bootstrap_source.h"

namespace ajar {

double bootstrap_share(const ChainPlan& plan, std::size_t group) {
  const auto weight = [](const PathGroup& g) { return 1.0 / std::max(1, g.depth); };
  double whole = 0.0;
  for (const PathGroup& other : plan.groups) whole += weight(other);
  return weight(plan.groups[group]) / whole;
}

void add_blocks(std::vector<SampleBlock>& blocks, std::size_t owner, std::uint64_t samples) {
  constexpr std::uint64_t kSamplesPerBlock = 512;
  for (std::uint64_t first = 0; first < samples; first += kSamplesPerBlock) {
    blocks.push_back({owner, first, std::min(samples, first + kSamplesPerBlock)});
  }
}

std::vector<ChainPopulation> make_populations(const ChainPlan& plan) {
  std::vector<ChainPopulation> populations;
  for (int replicate = 0; replicate < plan.settings.replicates; ++replicate) {
    for (std::size_t g = 0; g < plan.groups.size(); ++g) {
      ChainPopulation population;
      population.group = g;
      population.replicate = replicate;
      population.seed =
          hash_numbers(plan.settings.seed, 0xb0075ULL, replicate, plan.groups[g].depth);
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
        std::max(kFewest, per_replicate * bootstrap_share(plan_, populations_[p].group));
    populations_[p].weights.resize(static_cast<std::size_t>(samples));
    add_blocks(blocks_, p, populations_[p].weights.size());
  }
  return blocks_.size();
}

void ChainBootstrap::run(std::uint64_t item, Counters& counters) {
  const SampleBlock& block = blocks_[item];
  ChainPopulation& population = populations_[block.owner];
  const auto target = plan_.make_target(plan_.groups[population.group], population.replicate);
  SplatBuffer splats;
  for (std::uint64_t i = block.first; i < block.last; ++i) {
    BootstrapSource source(population.seed, i);
    splats.clear();
    const double scalar = target->evaluate(source, Change{}, splats);
    target->rejected();
    // What is not a number is counted when a chain meets it; it can be no seed.
    population.weights[i] = scalar > 0.0 && std::isfinite(scalar) ? scalar : 0.0;
  }
  counters.add_rays(target->ray_counts());
}

void ChainBootstrap::end() {
  if (blocks_.empty()) return;
  for (ChainPopulation& population : populations_) {
    for (const double weight : population.weights) {
      const double capped = std::min(weight, plan_.chain_settings.large_step_cap);
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
    const PathGroup& group = plan_.groups[population.group];
    const double u =
        to_unit_float(static_cast<std::uint32_t>(hash_numbers(population.seed, 0x5eedULL) >> 32U));
    ChainRecord empty;
    if (plan_.kind == ChainKind::OnePath) empty.by_technique.resize(group.choice.size());
    const std::vector<double>& weights = population.weights;
    const std::vector<double> filtered =
        filter_weights(weights, plan_.seed_filter, plan_.seed_spread);
    for (const std::size_t index : choose_seeds(filtered, shares[i], u)) {
      const std::uint64_t chain_seed =
          hash_numbers(population.seed, 0xc4a15ULL, population.chains.size());
      population.chains.push_back(
          {PrimaryChain(group.shape, chain_seed, bootstrap_key(population.seed, index),
                        weights[index]),
           empty, seed_weight(weights, filtered, plan_.seed_filter, index)});
    }
  }
}

}  // namespace ajar
