#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "mcmc/chain.h"
#include "mcmc/chain_statistics.h"
#include "mcmc/moments.h"

namespace ajar {

/// A chain with all it has done.
struct MemberChain {
  Chain chain;
  ChainStatistics statistics;
  std::vector<ChainStatistics::Kind> by_technique;  ///< numbered as in the group's choice
  double weight = 1.0;  ///< of what it deposits, relative to other chains (`seed_weight`)
};

/// The chains of one group in one replicate, with a bootstrap of their own.
struct ChainPopulation {
  std::size_t group = 0;
  int replicate = 0;
  std::uint64_t seed = 0;       ///< of its bootstrap
  std::vector<double> weights;  ///< I of the bootstrap samples; emptied once chains are seeded
  // Of I over the bootstrap, in two parts: min(I, cap) and the rest.
  Moments capped;
  Moments excess;
  std::vector<MemberChain> chains;
  /// Of samples taken where no seed was found.
  std::uint64_t plain_samples = 0;
  ChainStatistics plain_statistics;

  /// Of min(I, cap) over large steps, or over the samples taken instead: independent, too.
  Moments later_moments() const {
    Moments all = plain_statistics.large_steps;
    for (const MemberChain& member : chains) all += member.statistics.large_steps;
    return all;
  }
  /// b, if later samples have the weight `later_weight` in what is capped. The rest is the
  /// bootstrap's alone: a chain that was not seeded with a path of huge I does not render it, and
  /// if such a path, found later, raised b, its light would go to all others.
  double b(double later_weight) const {
    const Moments later = later_moments();
    const double weight = later.count > 0 ? later_weight : 0.0;
    return excess.mean() + (1.0 - weight) * capped.mean() + weight * later.mean();
  }
  double b_standard_error() const {
    Moments all = capped;
    all += later_moments();
    return std::hypot(all.standard_error(), excess.standard_error());
  }
};

}  // namespace ajar
