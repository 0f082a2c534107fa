#pragma once
#include <cstdint>

namespace ajar {

/// Mixes 64 bits so that each input bit affects every output bit (the finaliser of SplitMix64).
/// Source: Steele et al. 2014, "Fast splittable pseudorandom number generators"; constants by
/// D. Stafford ("Mix13").
constexpr std::uint64_t mix_bits(std::uint64_t v) {
  v ^= v >> 30;
  v *= 0xbf58476d1ce4e5b9ULL;
  v ^= v >> 27;
  v *= 0x94d049bb133111ebULL;
  v ^= v >> 31;
  return v;
}
/// Hash of a sequence of integers; the same on every machine.
constexpr std::uint64_t hash_numbers() { return 0x9e3779b97f4a7c15ULL; }
template <typename... Rest>
constexpr std::uint64_t hash_numbers(std::uint64_t first, Rest... rest) {
  return mix_bits(first +
                  0x9e3779b97f4a7c15ULL * (1 + hash_numbers(static_cast<std::uint64_t>(rest)...)));
}

/// Uniform float in [0, 1) from the upper 24 of 32 random bits.
constexpr float to_unit_float(std::uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24F;
}

/// Small sequential generator: PCG-XSH-RR 64/32. Source: O'Neill 2014.
class Rng {
 public:
  explicit constexpr Rng(std::uint64_t seed, std::uint64_t sequence = 0)
      : increment_((mix_bits(sequence) << 1U) | 1U) {
    next_bits();
    state_ += mix_bits(seed);
    next_bits();
  }
  constexpr std::uint32_t next_bits() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + increment_;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto rotation = static_cast<std::uint32_t>(old >> 59U);
    return (shifted >> rotation) | (shifted << ((~rotation + 1U) & 31U));
  }
  /// Uniform in [0, 1).
  constexpr float next() { return to_unit_float(next_bits()); }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

}  // namespace ajar
