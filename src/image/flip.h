#pragma once
#include <span>
#include <vector>

#include "core/vector.h"

/// ꟻLIP: how different two pictures look when they are flipped in place, per pixel, 0 (no
/// difference) to 1. Source: Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating
/// Images"; the constants are the paper's.
namespace ajar {

/// Pixels per degree of visual angle: a monitor 0.7 m and 3840 pixels wide, seen from 0.7 m. The
/// paper's default.
inline constexpr double kFlipPixelsPerDegree = 67.02064327658226;

/// Difference of each pixel. Both images are display-encoded (sRGB) RGB in [0, 1], 3 values per
/// pixel; anything beyond is clamped. `pixels_per_degree` > 0. Raises std::invalid_argument if the
/// images do not have `size`.
std::vector<float> flip_map(std::span<const float> image, std::span<const float> reference,
                            Vec2i size, double pixels_per_degree = kFlipPixelsPerDegree);

/// Mean of a map: the number that the paper reports for a pair of images.
double map_mean(std::span<const float> map);

}  // namespace ajar
