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
  /// Most paths that a camera sample is split into: estimates from few samples must not stop a
  /// render.
  /// Unit: paths. Range: >= 1. Source: docs/notebook/roulette.md, "Splitting".
  static constexpr int kMostPaths = 20;
  /// Share of the spread in a cell that more samples of one vertex reduce: the rest is between the
  /// vertices of the cell, or is spread evenly by Sobol' points anyway.
  /// Unit: standard deviation over standard deviation. Range: (0, 1]. Source:
  /// docs/notebook/roulette.md, "Splitting".
  static constexpr float kSpreadOfVertex = 0.1F;
  /// Samples with which a cell is known.
  /// Unit: samples. Range: >= 2. Source: docs/notebook/roulette.md, "Cells".
  static constexpr std::int64_t kFewestSamplesOfCell = 32;
  /// Samples with which a leaf of the octree is divided.
  /// Unit: samples. Range: > 8. Source: docs/notebook/roulette.md, "Cells".
  static constexpr std::int64_t kMostSamplesOfLeaf = 8192;
  /// Bound on the memory of cells, 204 bytes each.
  /// Unit: cells. Range: >= 8. Source: Rath et al. 2022 need 24 MiB.
  static constexpr std::size_t kMostCells = 1 << 17;
};

}  // namespace ajar
