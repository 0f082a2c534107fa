#pragma once
#include <cstdint>

namespace ajar {

/// The first milestone of a render after `samples` samples per pixel. Milestones are at 1, 2, 3, 4,
/// 6, 8, 12, 16, … samples per pixel and replicate. They depend on nothing but the number of
/// replicates, so that what is decided there is the same on any machine.
constexpr std::uint64_t milestone_after(std::uint64_t samples, std::uint64_t replicates) {
  constexpr std::uint64_t kLast = ~std::uint64_t{0};
  for (std::uint64_t base = replicates; base < kLast / 2; base *= 2) {
    if (base > samples) return base;
    // Half-way marks start at 3 = 1.5 · 2 samples per replicate, the first that is whole.
    const std::uint64_t half_way = base + base / 2;
    if (base > replicates && half_way > samples) return half_way;
  }
  return kLast;
}

/// The last milestone up to `samples` that is a power of two times the number of replicates; 0 if
/// there is none yet.
constexpr std::uint64_t last_doubling(std::uint64_t samples, std::uint64_t replicates) {
  if (samples < replicates) return 0;
  std::uint64_t milestone = replicates;
  while (2 * milestone <= samples) milestone *= 2;
  return milestone;
}

}  // namespace ajar
