#pragma once
#include <cstdint>

#include "core/random.h"
#include "core/random_use.h"

namespace ajar {

/// A sample of independent ones (`BootstrapSource`) that chains start from.
struct SampleOfChains {
  std::uint64_t seed = 0;   ///< seed of all of them
  std::uint64_t index = 0;  ///< index of this one
  double weight = 0.0;      ///< I

  std::uint64_t chain_seed(std::uint64_t number) const {
    return hash_numbers(seed, RandomUse::Chain, index, number);
  }
};

}  // namespace ajar
