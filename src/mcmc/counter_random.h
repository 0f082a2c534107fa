#pragma once
#include <cstdint>

#include "core/random.h"
#include "core/vector.h"
#include "transport/sample_source.h"

/// Random numbers without a generator to store: each is a hash of a key and of what it is for, so
/// that a Markov chain is a pure function of its seed and the number of its steps.
namespace ajar {

/// Number `index` of the sequence named by `key`: SplitMix64 with random access.
constexpr std::uint64_t counter_bits(std::uint64_t key, std::uint64_t index) {
  return mix_bits(key + (index + 1) * 0x9e3779b97f4a7c15ULL);
}
/// Uniform in [0, 1) with all 53 bits of a double.
constexpr double to_unit_double(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

/// Key for one vertex of one stream, from the key of a whole primary vector.
constexpr std::uint64_t block_key(std::uint64_t key, Stream stream, int vertex) {
  return counter_bits(
      key, static_cast<std::uint64_t>(stream) << 32U | static_cast<std::uint32_t>(vertex));
}
/// Slots 2·pair and 2·pair + 1 of a vertex in the fresh primary vector named by `key`.
inline Vec2 fresh_pair(std::uint64_t key_of_block, std::size_t pair) {
  const std::uint64_t bits = counter_bits(key_of_block, pair);
  return {to_unit_float(static_cast<std::uint32_t>(bits >> 32U)),
          to_unit_float(static_cast<std::uint32_t>(bits))};
}
inline Vec2 fresh_pair(std::uint64_t key, SampleAddress address) {
  return fresh_pair(block_key(key, address.stream(), address.vertex()),
                    static_cast<std::size_t>(address.slot()) / 2);
}

}  // namespace ajar
