#pragma once
#include "core/archive.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_population.h"
#include "integrator/strong_paths.h"

/// How the parts of a render with chains are written and read (see core/archive.h). Floats keep
/// their bits, so that chains go on as if nothing had been.
namespace ajar {

template <Archive A>
void serialize(A& archive, ChainPopulation::Joined& joined) {
  archive(joined.b, joined.variance, joined.of_recruits, joined.of_chains);
}

/// What samples in the place of chains have left behind.
template <Archive A, typename Population>
void serialize_plain(A& archive, Population& population) {
  archive(population.plain_samples, population.plain_statistics);
}

/// All that has happened to a population of a plan since the preparation.
template <Archive A, typename Population>
void serialize_population(A& archive, Population& population, const ChainPlan& plan) {
  serialize_plain(archive, population);
  archive(population.retired, population.samples_behind, population.joined);
  auto chains = static_cast<std::uint64_t>(population.chains.size());
  archive(chains);
  if constexpr (A::is_loading::value) population.chains.clear();
  for (std::uint64_t i = 0; i < chains; ++i) {
    if constexpr (A::is_loading::value) {
      SelectiveChain& chain = population.chains.emplace_back();
      if (!is_explicit(plan.groups[population.group].kind)) {
        chain.state = PrimaryChain(plan.groups[population.group].shape, 0, 0, 0.0);
      }
    }
    serialize_chain(archive, plan.scene, population.chains[static_cast<std::size_t>(i)]);
  }
}

template <Archive A>
void serialize(A& archive, StrongPath& path) {
  archive(path.technique.s, path.technique.t, path.raster.x, path.raster.y, path.replicate,
          path.strength);
  for (int lane = 0; lane < 4; ++lane) {
    float value = path.value[lane];
    archive(value);
    path.value.set(lane, value);
  }
  archive(path.energy, path.sample, path.hit_only);
}

}  // namespace ajar
