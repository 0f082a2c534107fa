#include "integrator/chain_bootstrap.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "mcmc/bootstrap.h"
#include "mcmc/bootstrap_source.h"

namespace ajar {

namespace {
/// Of a replicate with so many mutations per mutation per pixel. So many that a chain makes about a
/// hundred steps in a short pass: many chains are well spread, but each begins a pass by looking up
/// its state. Small pictures have more, down to one step, because few chains depend on luck.
std::uint64_t default_chains(std::uint64_t mutations) {
  constexpr std::uint64_t kSteps = 32;
  constexpr std::uint64_t kFewest = 32;
  return std::max<std::uint64_t>({1, mutations / kSteps, std::min(mutations, kFewest)});
}
}  // namespace

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

std::uint64_t ChainBootstrap::begin() {
  if (plan_.without_chains) return 0;
  constexpr double kFewest = 64.0;
  const double per_replicate = static_cast<double>(plan_.bootstrap) / plan_.settings.replicates;
  for (int replicate = 0; replicate < plan_.settings.replicates; ++replicate) {
    for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
      ChainPopulation population;
      population.group = g;
      population.replicate = replicate;
      population.seed =
          hash_numbers(plan_.settings.seed, 0xb0075ULL, replicate, plan_.groups[g].depth);
      const double samples = std::max(kFewest, per_replicate * bootstrap_share(plan_, g));
      population.weights.resize(static_cast<std::size_t>(samples));
      add_blocks(blocks_, populations_.size(), population.weights.size());
      populations_.push_back(std::move(population));
    }
  }
  return blocks_.size();
}

void ChainBootstrap::run(std::uint64_t item, Counters& counters) {
  const SampleBlock& block = blocks_[item];
  ChainPopulation& population = populations_[block.owner];
  const auto target = plan_.make_target(plan_.groups[population.group]);
  SplatBuffer splats;
  for (std::uint64_t i = block.first; i < block.last; ++i) {
    BootstrapSource source(population.seed, i);
    splats.clear();
    const double scalar = target->evaluate(source, Change{}, splats);
    target->rejected();
    // What is not a number is counted when a chain meets it; it can be no seed.
    population.weights[i] = scalar > 0.0 && std::isfinite(scalar) ? scalar : 0.0;
  }
  counters.rays += target->rays();
}

void ChainBootstrap::end() {
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
  const auto replicates = static_cast<std::uint64_t>(plan_.settings.replicates);
  const std::uint64_t count =
      plan_.wanted_chains > 0
          ? std::max<std::uint64_t>(1, plan_.wanted_chains / replicates)
          : default_chains(static_cast<std::uint64_t>(
                plan_.mutations * static_cast<double>(plan_.pixels()) / plan_.settings.replicates));
  const std::vector<std::size_t> shares = apportion(b, static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < own.size(); ++i) {
    ChainPopulation& population = *own[i];
    const PathGroup& group = plan_.groups[population.group];
    const double u =
        to_unit_float(static_cast<std::uint32_t>(hash_numbers(population.seed, 0x5eedULL) >> 32U));
    const std::size_t by_technique = plan_.kind == ChainKind::OnePath ? group.choice.size() : 0;
    const std::vector<double>& weights = population.weights;
    const std::vector<double> filtered =
        filter_weights(weights, plan_.seed_filter, plan_.seed_spread);
    for (const std::size_t index : choose_seeds(filtered, shares[i], u)) {
      const std::uint64_t chain_seed =
          hash_numbers(population.seed, 0xc4a15ULL, population.chains.size());
      population.chains.push_back(
          {Chain(group.shape, chain_seed, bootstrap_key(population.seed, index), weights[index]),
           {},
           std::vector<ChainStatistics::Kind>(by_technique),
           seed_weight(weights, filtered, plan_.seed_filter, index)});
    }
  }
}

}  // namespace ajar
