#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace ajar {

/// Vertex of each distinct corner of faces. Open addressing: files have millions of corners.
class CornerTable {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  /// Numbers of a position, a texture coordinate, a normal, and of the mesh that the face is in.
  using Corner = std::array<std::uint32_t, 4>;

  CornerTable() : entries_(std::size_t{1} << 10U) {}

  /// The vertex of `corner`, which is `fresh` if there was none, and whether that is so. `fresh` is
  /// not `kNone`.
  std::pair<std::uint32_t, bool> try_emplace(const Corner& corner, std::uint32_t fresh) {
    if (2 * count_ >= entries_.size()) grow();
    Entry& entry = place_of(corner);
    if (entry.vertex != kNone) return {entry.vertex, false};
    entry = {corner, fresh};
    ++count_;
    return {fresh, true};
  }

 private:
  struct Entry {
    Corner corner{};
    std::uint32_t vertex = kNone;
  };

  static std::size_t hash_of(const Corner& corner) {
    std::uint64_t hash = 0;
    for (const std::uint32_t number : corner) {
      hash = (hash ^ number) * 0xff51afd7ed558ccdULL;
      hash ^= hash >> 32U;
    }
    return static_cast<std::size_t>(hash);
  }
  /// Where it is, or the free place where it belongs.
  Entry& place_of(const Corner& corner) {
    const std::size_t mask = entries_.size() - 1;
    std::size_t place = hash_of(corner) & mask;
    while (entries_[place].vertex != kNone && entries_[place].corner != corner) {
      place = (place + 1) & mask;
    }
    return entries_[place];
  }
  void grow() {
    std::vector<Entry> before(2 * entries_.size());
    before.swap(entries_);
    for (const Entry& entry : before) {
      if (entry.vertex != kNone) place_of(entry.corner) = entry;
    }
  }

  std::vector<Entry> entries_;  ///< a power of two
  std::size_t count_ = 0;
};

}  // namespace ajar
