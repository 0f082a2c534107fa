#pragma once
#include <vector>

#include "core/vector.h"
#include "image/statistics.h"

namespace ajar {

/// How far a filter can be trusted with a picture, as its independent parts tell.
struct FilterTrust {
  /// The filtered picture where the filter helps, the unfiltered one where it harms. RGB, as the
  /// pictures are.
  std::vector<float> pixels;
  std::vector<float> unfiltered;  ///< its share, one value for each pixel, in [0, 1]
  std::vector<float> error;       ///< root of the mean squared error of `pixels`, likewise RGB
};

/// A filter D makes a picture smooth, and wrong where it takes light for noise. With replicates X
/// that no one of is filtered by what it is compared with,
///
///     (D(X₁) − X₂) · (D(X₃) − X₄)
///
/// is the squared error of E[D(X)] without bias: of a picture with as many samples as a replicate,
/// so rather more than that of the whole one. It is averaged over all orders of four replicates and
/// over a patch, relative to the filtered picture, so that the brightest pixel does not decide.
/// What is left, with V the variance of the unfiltered picture and V_D that of the filtered one, is
/// least for the share (B² + V_D) / (V + B² + V_D) of the unfiltered picture: it goes to 1 where
/// the error of the unfiltered picture goes to 0, which makes the whole consistent.
///
/// `unfiltered` and `filtered` are of the mean of the replicates; `replicates` and
/// `filtered_replicates` at least four. Source of the estimate of B²: docs/denoising.md. Raises
/// std::invalid_argument for fewer, or if sizes do not fit.
FilterTrust trust_filter(Vec2i size, const std::vector<float>& unfiltered,
                         const std::vector<float>& filtered, const Replicates& replicates,
                         const Replicates& filtered_replicates);

}  // namespace ajar
