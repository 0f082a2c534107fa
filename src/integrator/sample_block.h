#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

namespace ajar {

/// A range of independent samples of one of several owners.
struct SampleBlock {
  std::size_t owner;
  std::uint64_t first;
  std::uint64_t last;
};

/// Cuts `samples` of one owner into blocks.
inline void add_blocks(std::vector<SampleBlock>& blocks, std::size_t owner, std::uint64_t samples) {
  constexpr std::uint64_t kSamplesPerBlock = 512;
  for (std::uint64_t first = 0; first < samples; first += kSamplesPerBlock) {
    blocks.push_back({owner, first, std::min(samples, first + kSamplesPerBlock)});
  }
}

}  // namespace ajar
