#pragma once
#include <cstddef>
#include <cstdint>

namespace ajar {

/// The fitted numbers of the wing, beside parameters, which declare their own ranges.
struct MonteCarloHeuristics {
  // -------------------------------------------------------- errors of pixels
  /// Trimming of variances: the worst of so many pixels are left out, since chains' errors are in
  /// few. Unit: pixels. Range: > 1. Source: 3ed3aa3: trials on door-ajar, torus-in-glass, pool and
  /// teapot-full show a C of 4 to 5 without the worst of 100, and of 10, 7, 6 and 16 without that
  /// of 1000.
  static constexpr std::size_t kWorstOf = 1000;

  // -------------------------------------------------------- scale of a picture
  //
  // Groups for the median of means: it sets the unit of sums, and the scale of weak connections
  // (`cull`).

  /// Groups of camera samples of which means are taken.
  /// Unit: groups. Range: >= 1. Source: c7b4e5f; set by hand, no study.
  static constexpr std::size_t kScaleGroups = 16;
  /// Unit: camera samples of a group. Range: >= 1. Source: the same. 5b5c42c: 4096 in all are two
  /// per pixel of a small picture.
  static constexpr std::uint32_t kScaleGroupSize = 256;

  // -------------------------------------------------------- roulette by efficiency
  /// Camera samples of a pixel that all tell what their rays have brought.
  /// Unit: samples. Range: >= 1. Source: docs/notebook/roulette.md, "Cells".
  static constexpr std::uint64_t kSamplesToLearn = 2;
  /// Later ones tell it one time in so many, because telling takes time.
  /// Unit: samples. Range: >= 1. Source: docs/notebook/roulette.md, "Cells".
  static constexpr std::uint64_t kLearnsFromOneOf = 16;

  // -------------------------------------------------------- features
  /// Camera samples for each ray by which filters get to know the scene.
  /// Unit: samples. Range: >= 1. Source: docs/notebook/denoising.md, "Rays for features": half
  /// costs as much as it gains on caustic-glass, by what was measured with 16 and 64 rays.
  static constexpr std::uint64_t kSamplesForFeatureRay = 8;
  /// Bounds of these rays of a pixel.
  /// Unit: rays. Range: >= 1. Source: docs/notebook/denoising.md, "What is mixed": half
  /// and double not told from it.
  static constexpr std::uint32_t kFewestFeatureRays = 16;
  /// Unit: rays. Range: >= `kFewestFeatureRays`. Source: docs/notebook/denoising.md, "Rays for
  /// features".
  static constexpr std::uint32_t kMostFeatureRays = 64;

  /// Camera samples that look for paths beyond the techniques: effects of less than a thousandth of
  /// the picture may go unnoticed.
  /// Unit: samples. Range: >= 1. Source: set by hand, no study.
  static constexpr std::uint32_t kLookingAround = 4096;
  /// Glass of so many edges is looked through.
  /// Unit: edges. Range: >= 4. Source: set by hand; double names the same lamps in eighteen scenes.
  static constexpr int kLookingAroundEdges = 10;
  /// Rays that look for lamps from where their light lands behind glass.
  /// Unit: rays. Range: >= 1 / kRarelyMet. Source: set by hand, no study.
  static constexpr std::size_t kRaysBack = 16384;
  /// Lamps that fewer rays than this run into are found by chance.
  /// Unit: share. Range: (0, 1). Source: docs/notebook/equal-time-errors.md, "Small lamps behind
  /// glass"; half and double name the same lamps in eighteen scenes.
  static constexpr double kRarelyMet = 5e-4;
  /// Least share of all light that a lamp must send through glass to be named.
  /// Unit: share. Range: (0, 1). Source: as above, half and double, too.
  static constexpr double kLightOfSmallLamps = 0.01;
  /// Depths that are looked at one by one. Longer paths are as these are, unless many pairs are
  /// named one by one.
  /// Unit: edges. Range: >= 1. Source: set by hand, no study.
  static constexpr int kDepthsNamed = 8;
};

}  // namespace ajar
