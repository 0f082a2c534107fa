#pragma once
#include <array>
#include <cstdint>

namespace ajar {

/// The fitted numbers of moves in primary sample space, beside parameters, which declare their own
/// ranges, and those of papers (`PlaneRule`).
struct PrimaryHeuristics {
  /// Largest relative length of steps of the raster numbers alone, log-uniform from 1. Where
  /// directions alone decide, the next light may lie anywhere.
  /// Unit: factor. Range: [1, StepSizes::kLargest]. Source: docs/notebook/chains.md, "Directions
  /// that stay": FLIP on pool 0.328 with twice as long, 0.296 with six times, 0.288 with twenty
  /// times, 0.284 with 1 to 50 times.
  static constexpr double kRasterLength = 50.0;
  /// Fine steps are so many times shorter in variance, one as often as the other: 1/8 and 1/64 in
  /// length.
  /// Unit: factor. Range: whole, <= kStepUnits. Source: set by hand, no study; of their share
  /// (`fine-steps`) docs/notebook/chains.md has one.
  static constexpr std::array<std::uint64_t, 2> kFiner = {64, 4096};
  /// Steps that follow the picture (h of He et al. 2020) are not shorter than this.
  /// Unit: factor. Range: (0, 1]. Source: ede31ab, the inverse of the longest; the paper has no
  /// bound. No study.
  static constexpr float kShortestFactor = 1.F / 64.F;
};

}  // namespace ajar
