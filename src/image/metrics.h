#pragma once
#include <span>

#include "core/vector.h"

/// Distances between an image and a reference, over all values of all pixels and channels
/// (docs/compare.md). Both images have the same, non-zero number of values, else
/// std::invalid_argument. A value that is not finite makes a metric NaN or infinite: errors are not
/// hidden.
namespace ajar {

/// Mean of (a − r)².
double mse(std::span<const float> image, std::span<const float> reference);
double rmse(std::span<const float> image, std::span<const float> reference);
/// 10·log10(peak² / MSE), dB; infinite for equal images. For display values in [0, 1] the peak
/// is 1.
double psnr(std::span<const float> image, std::span<const float> reference, double peak = 1.0);
/// Mean of |a − r|.
double mae(std::span<const float> image, std::span<const float> reference);

/// The constant that keeps black from deciding the symmetric error.
inline constexpr double kSmapeEpsilon = 0.01;
/// Mean of |a − r| / (|a| + |r| + 0.01): symmetric in image and reference, in [0, 1). (SMAPE
/// without the factor 2 or 100 that some give it.) Source: Vogels et al. 2018, eq. 4, with its ε.
double smape(std::span<const float> image, std::span<const float> reference);

/// The constant that keeps dark pixels from dominating relMSE.
inline constexpr double kRelativeMseEpsilon = 0.01;
/// Mean of (a − r)²/(r² + 0.01).
double relative_mse(std::span<const float> image, std::span<const float> reference);
/// Relative MSE without the `trim` (fraction, rounded down to whole pixels) pixels of largest
/// error, so that a few fireflies do not decide. The error of a pixel is the mean over its
/// `channels` values, which lie side by side; a pixel whose error is no number counts as largest.
/// Raises std::invalid_argument if the values are not whole pixels.
double relative_mse_trimmed(std::span<const float> image, std::span<const float> reference,
                            int channels = 3, double trim = 0.001);
/// The error of a pixel (as above) that a share `below` of the pixels does not exceed: what a
/// person sees first. Raises as above.
double relative_mse_quantile(std::span<const float> image, std::span<const float> reference,
                             double below = 0.999, int channels = 3);
/// Error by scale E_σ: relMSE of picture and reference after a Gaussian of `sigma` pixels
/// (`blurred`). Independent noise falls with σ, correlated noise does not. Raises
/// std::invalid_argument if the images have not `size`.
double relative_mse_at_scale(std::span<const float> image, std::span<const float> reference,
                             Vec2i size, double sigma);

}  // namespace ajar
