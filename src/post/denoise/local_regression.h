#pragma once
#include <functional>
#include <vector>

#include "image/plane.h"

namespace ajar {

/// Inputs of a local regression; all planes of one size.
struct RegressionInput {
  const std::vector<Plane>& colour;  ///< filtered values: three channels
  const std::vector<Plane>& guide;   ///< guide of similarity: three channels
  const std::vector<Plane>&
      variance;  ///< variance of each value of the guide, without that of pixels around
  const std::vector<Plane>& features;  ///< noise-free regressors; none or six
};

/// A picture of linear models' values at each pixel: of the features and of the place, fitted to
/// the pixels of a window by weighted least squares. Weights are those of non-local means
/// (Rousselle, Knaus, Zwicker 2012, "Adaptive Rendering with Non-Local Means Filtering", eq. 3):
/// high for pixels around which the guide looks the same, as far as its variance lets one see. The
/// model is that of Bitterli et al. 2016, "Nonlinearly Weighted First-order Regression for
/// Denoising Monte Carlo Renderings" (without its prefilter of features, and of place, too), with a
/// ridge.
///
/// If guide and colour are of independent samples, weights are independent of the noise that they
/// weigh. `proceeds` is called, by any thread, after each part of so many pixels; false cancels the
/// work, and the result is invalid.
std::vector<Plane> local_regression(const RegressionInput& input,
                                    const std::function<bool(int pixels)>& proceeds);

}  // namespace ajar
