#pragma once
#include <cstdint>

#include "mcmc/chain_numbers.h"

namespace ajar {

/// A Markov chain between two runs: plain data, a pure function of (seed, origin, step). Its splats
/// are not kept; `ChainRunner` gets them back from the replay with which every run starts.
struct Chain {
  /// Starts at the fresh primary vector named by `origin_key` (`bootstrap_key`), where the target
  /// is `scalar_there` > 0.
  Chain(const PrimaryShape& shape, std::uint64_t chain_seed, std::uint64_t origin_key,
        double scalar_there)
      : seed(chain_seed), origin(origin_key), scalar(scalar_there), numbers(shape, origin_key) {}

  std::uint64_t seed;
  std::uint64_t origin;
  std::uint64_t step = 0;    ///< made so far
  std::uint64_t streak = 0;  ///< rejections since the last acceptance
  float step_scale = 1.F;    ///< of small steps, since the last large one (`PlaneMoves`)
  double scalar;             ///< I of the current state
  ChainNumbers numbers;

  std::size_t memory_bytes() const {
    return sizeof(*this) - sizeof(numbers) + numbers.memory_bytes();
  }
};

}  // namespace ajar
