#pragma once
#include <span>
#include <vector>

#include "core/vector.h"
#include "image/statistics.h"

/// Are two renders the same image but for noise? (docs/compare.md) Every block of pixels and
/// every channel is tested by itself, with the error of the block's mean taken from replicates of
/// that mean, so that correlation between pixels does no harm; then the tests are corrected for
/// their number.
namespace ajar {

/// Size of images and of the blocks they are cut into; blocks at the right and lower border may be
/// smaller.
struct BlockGrid {
  int width = 0;
  int height = 0;
  int channels = 3;
  int block = 16;  ///< pixels along each side
};

struct BlockComparison {
  int tests = 0;      ///< blocks × channels
  Box2i worst_block;  ///< pixels, min and max inclusive
  int worst_channel = 0;
  double worst_difference = 0;  ///< mean of a − mean of b in the worst block
  double worst_error = 0;       ///< standard error of that difference
  /// The difference in standard normal units: its t value, with Welch's degrees of freedom, moved
  /// to the normal quantile of equal probability.
  double worst_z = 0;
  double worst_p = 1;   ///< two-sided, of the worst block alone
  double family_p = 1;  ///< chance that any block looks this bad if the images are equal (Šidák)
  double mean_difference = 0;           ///< over the whole image, all channels
  double mean_error = 0;                ///< standard error of that
  double mean_freedom = 0;              ///< degrees of freedom of that error
  double mean_z = 0;                    ///< the difference in standard normal units
  double mean_relative_difference = 0;  ///< mean_difference / mean of b
  double typical_error = 0;    ///< standard error of the difference of a block's means: median over
                               ///< the tests
  double typical_freedom = 0;  ///< degrees of freedom of that error

  /// True unless a block or the whole image differs more than chance allows: an equal pair is
  /// called different with probability ≤ 2·alpha.
  bool equal(double alpha = 1e-6) const;
};

/// Tests two sets of replicates (R ≥ 2 each, at least 8 for useful power: with few degrees of
/// freedom a corrected t-test needs huge differences) against each other. Source: Welch 1947.
BlockComparison compare_blocks(const Replicates& a, const Replicates& b, const BlockGrid& grid);

/// Tests replicates against a fixed reference whose pixels have independent errors of the given
/// variance (one per value, or empty if the reference is exact). Errors of the channels of a pixel
/// may be correlated.
BlockComparison compare_blocks_to_reference(const Replicates& a, std::span<const float> reference,
                                            std::span<const float> reference_variance,
                                            const BlockGrid& grid);

/// Tests two images against each other by the variance of each of their values alone (one per
/// value; `b_variance` empty if b is exact). Sound only where the errors of pixels are independent,
/// that is without splats and chains, whose errors spread over many pixels. Variances are taken as
/// estimated with a single degree of freedom each, the least there can be.
BlockComparison compare_blocks_by_variance(std::span<const float> a,
                                           std::span<const float> a_variance,
                                           std::span<const float> b,
                                           std::span<const float> b_variance,
                                           const BlockGrid& grid);

/// The difference that a two-sided test at level `alpha` finds with probability `power`: (t_{1−α/2}
/// + t_{power}) · error, Student's quantiles with `freedom` degrees of freedom (infinite: normal).
double detectable_difference(double error, double freedom, double alpha, double power);

/// Standard normal quantile of the same two-sided probability as `t` with `degrees_of_freedom`;
/// keeps the sign. Clamped to ±37, where probabilities leave the range of double.
double normal_from_t(double t, double degrees_of_freedom);

}  // namespace ajar
