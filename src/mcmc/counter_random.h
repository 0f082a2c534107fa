#pragma once
#include <cstdint>

#include "core/random.h"

/// Random numbers without a generator to store: each is a hash of a key and of its purpose, so that
/// a Markov chain is a pure function of its seed and the number of its steps.
namespace ajar {

/// Number `index` of the sequence named by `key`: SplitMix64 with random access.
constexpr std::uint64_t counter_bits(std::uint64_t key, std::uint64_t index) {
  return mix_bits(key + (index + 1) * 0x9e3779b97f4a7c15ULL);
}
/// Uniform in [0, 1) with all 53 bits of a double.
constexpr double to_unit_double(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace ajar
