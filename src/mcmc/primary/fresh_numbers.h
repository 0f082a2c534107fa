#pragma once
#include <cstddef>
#include <cstdint>

#include "core/random.h"
#include "core/vector.h"
#include "mcmc/counter_random.h"
#include "transport/sample_source.h"

/// The primary vectors that keys name.
namespace ajar {

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
