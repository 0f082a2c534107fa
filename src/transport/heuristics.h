#pragma once
#include <cstddef>
#include <cstdint>

namespace ajar {

/// The fitted numbers of the room, beside parameters, which declare their own ranges.
struct TransportHeuristics {
  /// Least probability to survive where roulette judges by what was learned: what is not learned
  /// yet must not end all paths.
  /// Unit: probability. Range: (0, 1]. Source: Rath et al. 2022.
  static constexpr float kLeastSurvival = 0.05F;
  /// Light that a subpath brings counts as if it were worth so many rays at most: a firefly says
  /// that its way is worth thousands, while prices are those of visible errors.
  /// Unit: rays. Range: > 0. Source: docs/notebook/roulette.md, "Fireflies".
  static constexpr double kMostRays = 16.0;
  /// Samples with which a cell is known.
  /// Unit: samples. Range: >= 2. Source: docs/notebook/roulette.md, "Cells".
  static constexpr std::int64_t kFewestSamplesOfCell = 32;
  /// Samples with which a leaf of the octree is divided.
  /// Unit: samples. Range: > 8. Source: docs/notebook/roulette.md, "Cells".
  static constexpr std::int64_t kMostSamplesOfLeaf = 8192;
  /// Bound on the memory of cells, 104 bytes each.
  /// Unit: cells. Range: >= 8. Source: Rath et al. 2022 need 24 MiB.
  static constexpr std::size_t kMostCells = 1 << 17;
};

}  // namespace ajar
