#pragma once
#include <optional>
#include <span>

#include "core/vector.h"

namespace ajar {

/// Structural similarity, −1 to 1 (equal): the mean over windows of
///
///     (2 μa μr + C1)(2 σar + C2) / ((μa² + μr² + C1)(σa² + σr² + C2))
///
/// Conventions, those of the authors' own program: windows of 11×11 pixels with Gaussian weights
/// (σ = 1.5, adding up to 1), only those that lie inside the picture; C1 = 0.01², C2 = 0.03² for
/// values in [0, 1]; variances without Bessel's correction; no downsampling. Of colour, the grey
/// 0.299 R + 0.587 G + 0.114 B of the display values is compared. Both images are display-encoded
/// RGB. Empty if the picture is smaller than a window. Raises std::invalid_argument if the images
/// do not have `size`. Source: Wang et al. 2004, eq. 13–17.
std::optional<double> ssim(std::span<const float> image, std::span<const float> reference,
                           Vec2i size);

}  // namespace ajar
