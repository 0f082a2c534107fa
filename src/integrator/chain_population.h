#pragma once
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
  Moments bootstrap;
  std::vector<MemberChain> chains;
  /// Of samples taken where no seed was found.
  std::uint64_t plain_samples = 0;
  ChainStatistics plain_statistics;

  /// Of I over large steps, or over the samples taken instead: independent, too.
  Moments later_moments() const {
    Moments all = plain_statistics.large_steps;
    for (const MemberChain& member : chains) all += member.statistics.large_steps;
    return all;
  }
  /// Bootstrap and later samples together.
  Moments moments() const {
    Moments all = bootstrap;
    all += later_moments();
    return all;
  }
};

}  // namespace ajar
