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

/// Cuts the samples `first` to `last` of one owner into blocks.
inline void add_blocks(std::vector<SampleBlock>& blocks, std::size_t owner, std::uint64_t first,
                       std::uint64_t last) {
  constexpr std::uint64_t kSamplesPerBlock = 512;
  for (; first < last; first += kSamplesPerBlock) {
    blocks.push_back({owner, first, std::min(last, first + kSamplesPerBlock)});
  }
}

}  // namespace ajar
