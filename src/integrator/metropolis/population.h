#pragma once
#include <cstdint>
#include <vector>

#include "integrator/metropolis/member_chain.h"
#include "mcmc/moments.h"

namespace ajar {

/// The chains of one group of paths in one replicate, with a bootstrap of their own.
struct Population {
  std::size_t group = 0;
  int replicate = 0;
  std::uint64_t seed = 0;         ///< of its bootstrap
  std::vector<double> weights{};  ///< I of the bootstrap samples; emptied once chains are seeded
  Moments b{};                    ///< the same: its mean is ∫ I
  std::vector<MemberChain> chains{};
};

}  // namespace ajar
