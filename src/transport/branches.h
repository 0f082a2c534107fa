#pragma once
#include <array>
#include <cstdint>

#include "core/random.h"

namespace ajar {

/// Place of a camera path among the samples of each vertex where it was split. It names the random
/// numbers of the vertices from there on, so that a path can be traced again by itself.
class Branches {
 public:
  /// Paths are split at no more vertices than that.
  static constexpr std::size_t kMost = 8;

  bool full() const { return count_ == kMost; }
  /// The path is sample number `index` of `samples` from vertex `vertex` on. The first keeps the
  /// numbers that an undivided path has. Only if not `full`.
  void enter(int vertex, int index, int samples) {
    const std::uint64_t before = key();
    splits_[count_] = {vertex, samples * paths(),
                       index == 0 ? before : hash_numbers(before, vertex, index)};
    ++count_;
  }
  /// Goes back to before the last `enter`.
  void leave() { --count_; }
  /// Paths that the camera sample has for each one that was split as often as this one.
  int paths() const { return count_ == 0 ? 1 : splits_[count_ - 1].paths; }
  /// Name of the numbers of a vertex; 0 for those of a path that was not split.
  std::uint64_t key(int vertex) const {
    for (std::size_t i = count_; i > 0; --i) {
      if (splits_[i - 1].vertex <= vertex) return splits_[i - 1].key;
    }
    return 0;
  }
  /// Name of the path's last numbers.
  std::uint64_t key() const { return count_ == 0 ? 0 : splits_[count_ - 1].key; }

 private:
  struct Split {
    int vertex;
    int paths;
    std::uint64_t key;
  };
  std::array<Split, kMost> splits_{};
  std::size_t count_ = 0;
};

}  // namespace ajar
