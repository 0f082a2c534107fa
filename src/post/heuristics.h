#pragma once

namespace ajar {

/// The fitted numbers of this room.
struct PostHeuristics {
  // -------------------------------------------------------- exposure
  /// Blocks of which means are taken, so that noise does not decide.
  /// Unit: blocks along the longer side. Range: >= 1. Source: cb9085a; set by hand, no study.
  static constexpr int kExposureBlocks = 32;
  /// Share of the blocks that stays below white.
  /// Unit: share. Range: [0.5, 1]. Source: cb9085a; set by hand, no study.
  static constexpr double kBelowWhite = 0.75;

  // -------------------------------------------------------- antialiasing
  //
  // After FXAA (Lottes 2009); d2c038e: on slanted edges the squared error is under a quarter of
  // that of the stairs.

  /// Edges whose contrast is below this and the next one cannot be seen.
  /// Unit: luma. Range: [0, 1]. Source: d2c038e; set by hand, no study.
  static constexpr float kSmallestContrast = 1.F / 32.F;
  /// Unit: share of the brightest luma around. Range: [0, 1]. Source: d2c038e; set by hand, no
  /// study.
  static constexpr float kSmallestRelativeContrast = 1.F / 8.F;
  /// A stair ends where the luma along the edge has changed by this.
  /// Unit: share of the edge's contrast. Range: (0, 0.5]. Source: d2c038e; set by hand, no study.
  static constexpr float kEndOfStair = 0.25F;
  /// Stairs that are longer count as without an end.
  /// Unit: pixels. Range: >= 1. Source: d2c038e; set by hand, no study.
  static constexpr int kLongestStair = 32;

  // -------------------------------------------------------- denoising
  //
  // Studies: docs/notebook/denoising.md, "What is mixed".

  /// Patch over which the errors of estimates are averaged.
  /// Unit: pixels, standard deviation of a Gaussian. Range: [1, 32]. Source:
  /// docs/notebook/denoising.md, "What is mixed": 8 and 16 are worse on teapot-full, 2 is level.
  static constexpr double kErrorPatch = 4.0;
  /// Differences of filtered and unfiltered replicates count at most so much.
  /// Unit: the filtered picture. Range: >= 1. Source: 5def0ef; half and double not told
  /// from it.
  static constexpr float kMostDifference = 3.F;
  /// Errors of darker values are relative to this.
  /// Unit: share of the picture's median. Range: (0, 1]. Source: 5def0ef; a tenth is worse in
  /// door-ajar, ten times not told from it.
  static constexpr double kDarkest = 0.01;

  // -------------------------------------------------------- the built-in filter
  //
  // Studies: docs/notebook/denoising.md, "The built-in filter".

  /// Window of the regression.
  /// Unit: pixels to either side. Range: [2, 16]. Source: docs/notebook/denoising.md.
  static constexpr int kRegressionWindow = 5;
  /// Patches that are compared.
  /// Unit: pixels to either side. Range: [0, 4]. Source: docs/notebook/denoising.md.
  static constexpr int kRegressionPatch = 1;
  /// Differences that count as large.
  /// Unit: standard deviations. Range: (0, 4]. Source: docs/notebook/denoising.md.
  static constexpr float kRegressionTolerance = 0.7F;
  /// Added to the variance of regressors: slopes with little support are small.
  /// Unit: features and windows squared. Range: (0, 1]. Source: docs/notebook/denoising.md.
  static constexpr float kRidge = 1e-3F;
  /// Patch over which the variance of a pixel is averaged.
  /// Unit: pixels to either side. Range: [1, 8]. Source: docs/notebook/denoising.md.
  static constexpr int kVariancePatch = 2;
  /// A pixel counts at most as so much light as those around it.
  /// Unit: their mean. Range: >= 2. Source: docs/notebook/denoising.md.
  static constexpr float kBrightestPixel = 10.F;
  /// Neighbourhood of that mean.
  /// Unit: pixels to either side. Range: [1, 8]. Source: docs/notebook/denoising.md.
  static constexpr int kAroundPixel = 3;
  /// Patch over which a finer picture is compared with a coarser one.
  /// Unit: pixels of the coarser one to either side. Range: [1, 16]. Source:
  /// docs/notebook/denoising.md.
  static constexpr int kScalePatch = 5;
  /// Confidence required to prefer the finer one.
  /// Unit: standard errors. Range: >= 0. Source: docs/notebook/denoising.md.
  static constexpr float kScaleDoubt = 2.F;
};

}  // namespace ajar
