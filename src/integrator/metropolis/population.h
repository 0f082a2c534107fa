#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"
#include "core/random_use.h"
#include "integrator/metropolis/heuristics.h"
#include "integrator/metropolis/member_chain.h"
#include "integrator/sample_block.h"

/// Populations, their bootstraps and their seeds. `P`: what a method knows of one beyond this.
namespace ajar {

/// The chains of one group of paths in one replicate, with a bootstrap of their own. `Member`: one
/// of them and its record.
template <typename Member>
struct PopulationOf {
  std::size_t group = 0;
  int replicate = 0;
  std::uint64_t seed = 0;       ///< seed of its bootstrap
  std::vector<double> weights;  ///< I of the bootstrap samples; emptied once chains are seeded
  std::vector<Member> chains;
};
using Population = PopulationOf<MemberChain>;

/// One for each replicate and group, group by group of a replicate, without chains yet. `seed`: of
/// the render.
template <typename P>
std::vector<P> make_populations(std::span<const PathGroup> groups, int replicates,
                                std::uint64_t seed) {
  std::vector<P> populations;
  for (int replicate = 0; replicate < replicates; ++replicate) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      P& population = populations.emplace_back();
      population.group = g;
      population.replicate = replicate;
      population.seed = hash_numbers(seed, RandomUse::Bootstrap, replicate, groups[g].depth);
    }
  }
  return populations;
}

/// Makes room for the bootstrap of each, `samples` in all or a few more, and cuts it into blocks.
template <typename P>
std::vector<SampleBlock> share_bootstrap(std::vector<P>& populations,
                                         std::span<const PathGroup> groups, int replicates,
                                         std::uint64_t samples) {
  const double per_replicate = static_cast<double>(samples) / replicates;
  std::vector<SampleBlock> blocks;
  for (std::size_t p = 0; p < populations.size(); ++p) {
    std::vector<double>& weights = populations[p].weights;
    weights.resize(static_cast<std::size_t>(
        std::max(MetropolisHeuristics::kFewestBootstrapPaths,
                 per_replicate * bootstrap_share(groups, populations[p].group))));
    add_blocks(blocks, p, 0, weights.size());
  }
  return blocks;
}

/// A block of a population's bootstrap; `target` is of its group.
template <typename Member>
void sample_bootstrap(PopulationOf<Member>& population, const SampleBlock& block,
                      PathTarget& target, Counters& counters) {
  sample_bootstrap(target, population.seed, block.first, block.last,
                   std::span(population.weights).subspan(block.first));
  counters.add_rays(target.ray_counts());
}

/// Shares `chains` in each replicate among its depths in proportion to b, so that each chain stands
/// for about as much light, and has each population seed its own. `b_of`: of a population; `seed`:
/// of a population and a number.
template <typename P, typename B, typename S>
void share_chains(std::vector<P>& populations, std::span<const PathGroup> groups,
                  std::size_t chains, const B& b_of, const S& seed) {
  for (std::size_t first = 0; first < populations.size(); first += groups.size()) {
    const std::span<P> own = std::span(populations).subspan(first, groups.size());
    std::vector<double> b;
    for (const P& population : own) b.push_back(b_of(population));
    const std::vector<std::size_t> shares = apportion(b, chains);
    for (std::size_t g = 0; g < own.size(); ++g) {
      seed(own[g], shares[g]);
      own[g].weights = {};
    }
  }
}

/// Seeds populations of chains of primary numbers.
template <typename P, typename B>
void seed_populations(std::vector<P>& populations, std::span<const PathGroup> groups,
                      std::size_t chains, const B& b_of, const SeedRule& rule = {}) {
  share_chains(populations, groups, chains, b_of, [&](P& population, std::size_t count) {
    population.chains =
        seed_chains(groups[population.group], population.seed, population.weights, count, rule);
  });
}

}  // namespace ajar
