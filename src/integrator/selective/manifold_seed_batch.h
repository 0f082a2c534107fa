#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "integrator/selective/chain_population.h"
#include "integrator/selective/preparation.h"

namespace ajar {

/// A path that no connection makes, found by a manifold connection.
struct ManifoldSeedPath {
  Path path;
  double energy;      ///< as in `OutlierPath`
  std::uint64_t key;  ///< names the randomness of a chain that starts there
};

/// Camera samples of one replicate in an epoch; `number` tells epochs apart.
struct SampleRange {
  double samples;
  std::uint64_t number;
};

/// Manifold connections for chains to start from, `SelectiveHeuristics::kManifoldTries` for each
/// camera sample. Their randomness depends on the epoch alone, so they are made in small parts
/// between passes, and made again after a render is resumed.
class ManifoldSeedBatch {
 public:
  /// `prepared` must outlive it.
  explicit ManifoldSeedBatch(const SelectivePreparation& prepared) : prepared_(prepared) {}

  /// Makes those of a fraction `done` in [0, 1] of the epoch. `ranges`: by replicate.
  void advance(const std::vector<ChainPopulation>& populations,
               const std::vector<SampleRange>& ranges, double done);
  /// Finds of a population, when all of its epoch is done.
  std::vector<ManifoldSeedPath> take(std::size_t population) {
    return std::move(tried_[population].found);
  }
  /// Begins the next epoch.
  void clear() { tried_.clear(); }

 private:
  struct Tried {
    std::uint64_t tries = 0;
    std::vector<ManifoldSeedPath> found;  ///< in the order of the tries
  };
  double tries_in(const ChainPopulation& population, const SampleRange& range) const;

  const SelectivePreparation& prepared_;
  std::vector<Tried> tried_;  ///< by population
};

}  // namespace ajar
