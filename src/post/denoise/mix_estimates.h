#pragma once
#include <vector>

#include "core/vector.h"
#include "image/statistics.h"

namespace ajar {

/// A picture made by something that may be wrong, such as a filter: RGB interleaved, row by row.
struct BiasedEstimate {
  std::vector<float> pixels;
  Replicates replicates;  ///< estimates of each replicate alone; at least four
  /// Input of the estimates, if it may lack light which the unbiased replicates have; else empty.
  Replicates found{};
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
/// weight to the worse ones (docs/notebook/denoising.md). With replicates X that are unbiased, and
/// estimates D of them, independent of those that they are compared with,
///
///     (D₁ − X₂) · (D₃ − X₄)
///
/// is the squared bias of D without bias (ours; docs/methods/denoising.md): that of a picture of as
/// many samples as one replicate. The bias of a filter falls with the noise of its input, so a
/// quarter of that is taken for the whole. Light that has not been found yet does not: all of the
/// squared bias counts that the estimate had before the filter. It is averaged over all orders of
/// four replicates and over a patch, relative to the estimates, so that bright pixels do not
/// dominate; the spread of the replicates of D is added to it. Errors of the mixture are at most
/// the mean of those of its parts, weighted by their shares, which is the value of `error`.
///
/// `unbiased`: as many replicates as the estimates have. Raises std::invalid_argument if there are
/// no estimates, too few replicates, or sizes that do not fit.
MixedEstimate mix_estimates(Vec2i size, const std::vector<BiasedEstimate>& estimates,
                            const Replicates& unbiased);

/// The unfiltered picture as an estimate: where it is brighter than the filtered one by far
/// (`PostHeuristics::kMostDifference`), and most of its replicates are not, it is a firefly, and as
/// they are. Raises std::invalid_argument as `replicate_median` does.
std::vector<float> without_fireflies(const std::vector<float>& picture,
                                     const Replicates& replicates,
                                     const std::vector<float>& filtered);

}  // namespace ajar
