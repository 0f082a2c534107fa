#pragma once
#include <span>

#include "core/vector.h"
#include "image/tone_curve.h"

/// Exposure of a picture for display, and how much of it is clipped.
namespace ajar {

/// The most stops that a picture may be brightened or darkened by.
inline constexpr float kMostStops = 64.F;

/// The exposure, in stops and a multiple of 0.1, at which a scene-linear picture is easy to look
/// at: the median of its luminance becomes middle grey (0.18), or less where more than a quarter of
/// it would be beyond white. 0 for a picture without light.
///
/// The median is that of the means of square blocks, 32 along the longer side, so that sparse
/// bright samples count as their mean. Blocks without light do not count. Fireflies, a lamp in the
/// picture, or the night around it have little influence. Source: Reinhard et al. 2002, for the key
/// of 0.18; the rest is ours.
float fitting_exposure(std::span<const float> rgb, Vec2i size);

/// Shares of a picture's pixels that are clipped, by luminance.
struct Clipping {
  double white = 0.0;  ///< as bright as white: 255 of 255
  double black = 0.0;  ///< as dark as black: at most 6 of 255
};
Clipping clipping(std::span<const float> rgb, ToneMap curve, float exposure);

}  // namespace ajar
