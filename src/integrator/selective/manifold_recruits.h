#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_population.h"

namespace ajar {

/// A path that no connection makes, found by manifold connections.
struct ManifoldRecruit {
  Path path;
  double energy;      ///< as of a `StrongPath`
  std::uint64_t key;  ///< names the randomness of a chain that starts there
};

/// Camera samples of a replicate that what is found stands for; numbers tell stretches of a render
/// apart.
struct RecruitStretch {
  double samples;
  std::uint64_t number;
};

/// Manifold connections for chains to start from, `SelectiveHeuristics::kManifoldTries` for each
/// camera sample. Which are tried depends on the stretch alone, not on when. So they are made bit
/// by bit between passes, none of which has to wait for long, and what was made is forgotten where
/// a render breaks off: who takes it up makes it again.
class ManifoldRecruits {
 public:
  /// `plan` must outlive it.
  explicit ManifoldRecruits(const ChainPlan& plan) : plan_(plan) {}

  /// Makes those of all populations that a share `done` in [0, 1] of their stretch has.
  /// `stretches`: by replicate.
  void go_on(const std::vector<ChainPopulation>& populations,
             const std::vector<RecruitStretch>& stretches, double done);
  /// All that a population has found, when all of its stretch is done.
  std::vector<ManifoldRecruit> take(std::size_t population) {
    return std::move(tried_[population].found);
  }
  /// The next stretch.
  void clear() { tried_.clear(); }

 private:
  struct Tried {
    std::uint64_t tries = 0;
    std::vector<ManifoldRecruit> found;  ///< in the order of the tries
  };
  double tries_in(const ChainPopulation& population, const RecruitStretch& stretch) const;

  const ChainPlan& plan_;
  std::vector<Tried> tried_;  ///< by population
};

}  // namespace ajar
