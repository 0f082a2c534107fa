#pragma once
#include <cmath>
#include <cstdint>
#include <optional>

#include "integrator/metropolis/population.h"
#include "integrator/selective/selective_chain.h"
#include "mcmc/moments.h"

namespace ajar {

/// What chains that share the light with ordinary Monte Carlo know beyond.
struct ChainPopulation : PopulationOf<SelectiveChain> {
  // Of I over the bootstrap, in two parts: min(I, cap) and the rest.
  Moments capped;
  Moments excess;
  ChainRecord retired;          ///< of chains that others have replaced
  double samples_behind = 0.0;  ///< camera samples that recruits were found with
  /// What is known of b if chains are recruits (`ChainRecruits`).
  struct Joined {
    double b;
    double variance;     ///< of b
    double of_recruits;  ///< what of b is due to a recruit, per luminance · importance
    double of_chains;    ///< to the chains that were there before
  };
  std::optional<Joined> joined;
  /// Of samples taken where no seed was found.
  std::uint64_t plain_samples = 0;
  ChainStatistics plain_statistics;

  /// Of min(I, cap) over large steps, or over the samples taken instead: independent, too.
  Moments later_moments() const {
    Moments all = plain_statistics.large_steps;
    for (const SelectiveChain& member : chains) all += member.record.statistics.large_steps;
    return all;
  }
  /// b, if later samples have the weight `later_weight` in what is capped. The rest is the
  /// bootstrap's alone: a chain that was not seeded with a path of huge I does not render it, and
  /// if such a path, found later, raised b, its light would go to all others.
  double b(double later_weight) const {
    if (joined) return joined->b;
    const Moments later = later_moments();
    const double weight = later.count > 0 ? later_weight : 0.0;
    return excess.mean() + (1.0 - weight) * capped.mean() + weight * later.mean();
  }
  double b_standard_error() const {
    if (joined) return std::sqrt(joined->variance);
    Moments all = capped;
    all += later_moments();
    return std::hypot(all.standard_error(), excess.standard_error());
  }
};

}  // namespace ajar
