#pragma once
#include "core/archive.h"
#include "integrator/outlier_paths.h"
#include "integrator/selective/chain_population.h"
#include "integrator/selective/preparation.h"

/// Archives of the parts of a render with chains (core/archive.h). Floats keep their bits, so that
/// chains go on as if nothing had been.
namespace ajar {

/// State of a population after the preparation.
template <Archive A, typename Population>
void serialize_population(A& archive, Population& population,
                          const SelectivePreparation& prepared) {
  archive(population.retired, population.samples_behind, population.b);
  auto chains = static_cast<std::uint64_t>(population.chains.size());
  archive(chains);
  if constexpr (A::is_loading::value) population.chains.clear();
  const PathGroup& group = prepared.groups()[population.group];
  for (std::uint64_t i = 0; i < chains; ++i) {
    if constexpr (A::is_loading::value) {
      SelectiveChain& chain = population.chains.emplace_back();
      if (!is_explicit(group.kind)) chain.state = PrimaryChain(group.shape, 0, 0, 0.0);
    }
    serialize_chain(archive, prepared.scene(), population.chains[static_cast<std::size_t>(i)]);
  }
}

template <Archive A>
void serialize(A& archive, OutlierPath& path) {
  archive(path.technique.s, path.technique.t, path.raster.x, path.raster.y, path.replicate,
          path.strength);
  for (int lane = 0; lane < 4; ++lane) {
    float value = path.value[lane];
    archive(value);
    path.value.set(lane, value);
  }
  archive(path.energy, path.sample, path.unidirectional_only);
}

}  // namespace ajar
