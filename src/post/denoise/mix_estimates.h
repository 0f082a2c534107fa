#pragma once
#include <vector>

#include "core/vector.h"
#include "image/statistics.h"

namespace ajar {

/// A picture made by something that may be wrong, such as a filter: RGB interleaved, row by row.
struct BiasedEstimate {
  std::vector<float> pixels;
  /// Estimates of parts of the samples alone, at least two of them, P: part p is made of the
  /// replicates p, p + P, p + 2 P, ….
  Replicates parts;
  /// Replicates before the estimate, if they may lack light which the unbiased ones have; else
  /// empty.
  Replicates found{};
  bool is_smooth = true;  ///< false: its pixels have the noise of the samples
};

/// Several estimates of one picture as one.
struct MixedEstimate {
  std::vector<float> pixels;
  /// Root of the mean squared error of each value, of which errors of single pixels are unknown: as
  /// large as it is around.
  std::vector<float> error;
  std::vector<std::vector<float>>
      shares;  ///< weights of each estimate, one value for each pixel; they sum to 1
};

/// Mixes estimates in inverse proportion to the squares of their squared errors, patch by patch:
/// proportion to the squared errors themselves, best for independent estimates, gives too much
/// weight to the worse ones (docs/notebook/denoising.md). With parts X_p of the samples, which are
/// unbiased, and estimates D_p of the same parts,
///
///     (D₁ − X₁) · (D₂ − X₂)
///
/// is the squared bias of D without bias (ours; docs/methods/denoising.md), since parts are
/// independent: the bias of a picture of as many samples as one part. The bias of a filter falls
/// with the noise of its input, so of P parts a P-th of that is taken for the whole. Light that has
/// not been found yet does not: all of the squared bias counts that the estimate had before the
/// filter. It is averaged over all pairs of parts and over a patch, relative to the least
/// of the smooth estimates, so that bright pixels do not dominate: noise that decides its own
/// weight looks like bias, and clumps that do, like none. The spread of the parts of D is added to
/// it. Errors of the mixture are at most the mean of those of its parts, weighted by their shares,
/// which is the value of `error`.
///
/// `unbiased`: at least as many replicates as an estimate has parts. Raises std::invalid_argument
/// if there are no estimates, too few parts or replicates, or sizes that do not fit.
MixedEstimate mix_estimates(Vec2i size, const std::vector<BiasedEstimate>& estimates,
                            const Replicates& unbiased);

/// The unfiltered picture as an estimate: where it is brighter than the filtered one by far
/// (`PostHeuristics::kMostDifference`), and most of its replicates are not, it is a firefly, and as
/// they are. Raises std::invalid_argument as `replicate_median` does.
std::vector<float> without_fireflies(const std::vector<float>& picture,
                                     const Replicates& replicates,
                                     const std::vector<float>& filtered);

}  // namespace ajar
