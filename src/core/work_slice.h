#pragma once
#include <cstdint>

namespace ajar {

/// A part of the work, so that several processes can share a render: those items i of each pass
/// with i mod count = index. The sums of all parts together are the whole, to the bit.
struct WorkSlice {
  std::uint64_t index = 0;
  std::uint64_t count = 1;
  bool has(std::uint64_t item) const { return item % count == index; }
  /// Part of `items` that belongs to this worker.
  std::uint64_t size(std::uint64_t items) const {
    return items / count + (items % count > index ? 1 : 0);
  }
  bool operator==(const WorkSlice&) const = default;
};

}  // namespace ajar
