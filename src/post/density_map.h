#pragma once
#include <span>
#include <vector>

#include "core/spectrum.h"
#include "core/vector.h"

namespace ajar {

/// Colour of `t` in [0, 1], linear RGB within the gamut of sRGB: from dark violet over blue and
/// green to light yellow. Equal steps of t are equal steps of lightness, and nearly equal steps to
/// the eye (distances in Oklab between neighbours differ by at most a fifth). Source of the
/// space: Ottosson 2020, "A perceptual color space for image processing".
Spectrum density_color(float t);

/// A picture of its own: linear RGB, row by row from the top.
struct DensityMap {
  Vec2i size;
  std::vector<float> rgb;
};
/// Draws visits per pixel, relative to their mean, in false colours with a legend at the right. The
/// scale is logarithmic and always the same, from 1/16 to 16, so that maps can be compared; pixels
/// without visits are black.
DensityMap draw_density_map(std::span<const float> visits, const Vec2i& size);

}  // namespace ajar
