#pragma once
#include <cstddef>
#include <cstdint>

#include "mcmc/chain.h"
#include "mcmc/primary/chain_numbers.h"

namespace ajar {

/// A chain in primary sample space. Its splats are not kept; `PrimaryKernel` gets them back from
/// the replay with which every run starts.
struct PrimaryChain : Chain {
  /// Starts at the fresh primary vector named by `origin_key` (`bootstrap_key`), where the target
  /// is `scalar_there` > 0.
  PrimaryChain(const PrimaryShape& shape, std::uint64_t chain_seed, std::uint64_t origin_key,
               double scalar_there)
      : Chain{chain_seed, 0, 0, scalar_there}, origin(origin_key), numbers(shape, origin_key) {}

  std::uint64_t origin;
  float step_scale = 1.F;  ///< scale of small steps, since the last large one (`PlaneMoves`)
  ChainNumbers numbers;

  std::size_t memory_bytes() const {
    return sizeof(*this) - sizeof(numbers) + numbers.memory_bytes();
  }
  template <typename Archive>
  void serialize(Archive& archive) {
    Chain::serialize(archive);
    archive(origin, step_scale, numbers);
  }
};

}  // namespace ajar
