#include "integrator/selective/manifold_seed_batch.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/parallel_for.h"
#include "core/random.h"
#include "core/random_use.h"
#include "integrator/metropolis/path_seeds.h"
#include "integrator/sample_block.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

double ManifoldSeedBatch::tries_in(const ChainPopulation& population,
                                   const SampleRange& range) const {
  if (!PathSeeds::has_manifolds(prepared_.groups()[population.group])) return 0.0;
  return std::ceil(range.samples * SelectiveHeuristics::kManifoldTries);
}

void ManifoldSeedBatch::advance(const std::vector<ChainPopulation>& populations,
                                const std::vector<SampleRange>& ranges, double done) {
  const auto range_of = [&](const ChainPopulation& population) -> const SampleRange& {
    return ranges[static_cast<std::size_t>(population.replicate)];
  };
  tried_.resize(populations.size());
  std::vector<SampleBlock> blocks;
  for (std::size_t p = 0; p < populations.size(); ++p) {
    const double all = tries_in(populations[p], range_of(populations[p]));
    const auto wanted = static_cast<std::uint64_t>(all * done);
    if (wanted > tried_[p].tries) add_blocks(blocks, p, tried_[p].tries, wanted);
    tried_[p].tries = std::max(tried_[p].tries, wanted);
  }
  std::vector<std::vector<ManifoldSeedPath>> found(blocks.size());
  parallel_for(blocks.size(), [&](std::size_t block) {
    const ChainPopulation& population = populations[blocks[block].owner];
    const SampleRange& range = range_of(population);
    const double energy =
        range.samples / tries_in(population, range) * prepared_.view.area_per_pixel();
    const std::uint64_t seed = hash_numbers(population.seed, RandomUse::ManifoldSeed, range.number);
    PathSeeds seeds(prepared_.scene(), prepared_.groups()[population.group], prepared_.view,
                    prepared_.part_of(population.replicate), SelectiveHeuristics::kManifoldTries);
    for (std::uint64_t i = blocks[block].first; i < blocks[block].last; ++i) {
      std::uint64_t key = hash_numbers(seed, i);
      for (PathSeeds::Joined& joined : seeds.join_by_manifolds(key)) {
        key = hash_numbers(key, RandomUse::Chain);
        found[block].push_back({std::move(joined.path), joined.brings * energy, key});
      }
    }
  });
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    std::move(found[block].begin(), found[block].end(),
              std::back_inserter(tried_[blocks[block].owner].found));
  }
}

}  // namespace ajar
