#pragma once
#include <cmath>

#include "integrator/metropolis/population.h"
#include "integrator/selective/selective_chain.h"

namespace ajar {

/// Chains that share the light with ordinary Monte Carlo, with what is known of their b.
struct ChainPopulation : PopulationOf<SelectiveChain> {
  ChainRecord retired;          ///< record of chains that others have replaced
  double samples_behind = 0.0;  ///< camera samples that seeds were found with
  /// b, as `SeedReservoir` estimates it.
  struct Brightness {
    double total = 0.0;
    double variance = 0.0;
    double per_seed = 0.0;   ///< part of a seed, per luminance · importance
    double of_chains = 0.0;  ///< part of the chains that were there before the last merge
    template <typename Archive>
    void serialize(Archive& archive) {
      archive(total, variance, per_seed, of_chains);
    }
  } b;
};

}  // namespace ajar
