#pragma once
#include <array>
#include <cstddef>

namespace ajar {

/// The fitted numbers of this room. Those of published metrics (FLIP, SSIM) and of definitions
/// (docs/methods/error-estimate.md) stay where they are.
struct ImageHeuristics {
  // -------------------------------------------------------- estimated error
  /// Places over which the squared error is summed: as wide as what filters make of one splat.
  /// Unit: pixels across. Range: >= 1. Source: docs/methods/error-estimate.md; 51b6652, half and
  /// double not measured.
  static constexpr std::size_t kPlace = 4;
  /// With fewer places the relative standard deviation of the value is more than 10 % (of a sum of
  /// n equal squares: sqrt(1/n), half of that of its root), and rare paths are still missing.
  /// Unit: places. Range: >= 1. Source: docs/notebook/equal-time-errors.md, "When the estimate is a
  /// bound": values within 10 % of the truth are 83 % of the renders that are not bounds with 15 or
  /// 25, 78 % with 10, 91 % with 40.
  static constexpr double kFewestPlaces = 25.0;
  /// Share of the places of small pictures, which have fewer.
  /// Unit: share. Range: (0, 1]. Source: 51b6652; set by hand, no study.
  static constexpr double kFewestOfPlaces = 0.25;

  /// Radius of the mean below which no pixel counts as dark in a bound of the error.
  /// Unit: pixels to either side. Range: >= 1. Source: docs/notebook/equal-time-errors.md, "When
  /// the estimate is a bound": bounds are 64 % of the truth in the median, none of 47 above 1.1
  /// times it; with 2 they are 53 %, with 4 69 %, and 6 % above.
  static constexpr int kAroundFirefly = 3;

  // -------------------------------------------------------- smoothed reference
  /// Rounds of averages, by how far apart neighbours are.
  /// Unit: pixels. Range: powers of two from 1 on. Source: the à-trous scheme (Dammertz et al.
  /// 2010); 51b6652, fewer or more not measured.
  static constexpr std::array<int, 5> kSmoothingStrides = {1, 2, 4, 8, 16};
  /// Relative standard error of a pixel that is good enough as it is.
  /// Unit: share. Range: > 0. Source: 51b6652; set by hand, no study.
  static constexpr float kQuiet = 0.05F;
  /// Two patches look the same if their mean squared difference is at most so many times what noise
  /// explains; the noise of the darker replicates is less than that of all.
  /// Unit: factor. Range: >= 1. Source: 51b6652; set by hand, no study.
  static constexpr float kSamePatch = 4.F;

  // -------------------------------------------------------- importance map
  /// What is added to luminances before the inverse is taken.
  /// Unit: share of the mean luminance. Range: > 0. Source: c345e65; set by hand, no study.
  static constexpr double kImportanceDelta = 0.05;
  /// Luminances are blurred over so many pixels on either side, twice.
  /// Unit: pixels. Range: >= 0. Source: c345e65; set by hand, no study.
  static constexpr int kImportanceBlur = 3;
  /// A firefly says little about its neighbours: luminances count up to this.
  /// Unit: factor over the mean luminance. Range: > 1. Source: c345e65; set by hand, no study.
  static constexpr double kMostLuminance = 20.0;
  /// No pixel has less.
  /// Unit: share of the mean weight. Range: > 0. Source: c345e65; set by hand, no study.
  static constexpr float kImportanceFloor = 1.F / 64.F;

  // -------------------------------------------------------- visible error
  /// Of the variance: half of the power that FLIP takes differences of colours to (q_c = 0.7).
  /// Unit: exponent. Range: (0, 0.5]. Source: Andersson et al. 2020 and 3077191: on torus-in-glass
  /// FLIP is 0.087 instead of 0.092 with 0.5, the mean standard error.
  static constexpr double kVisibleExponent = 0.35;
  /// Numbers of mutations that are tried for the least of it.
  /// Unit: numbers per octave. Range: > 0. Source: 3077191; set by hand, no study.
  static constexpr double kTriedPerOctave = 2.0;
};

}  // namespace ajar
