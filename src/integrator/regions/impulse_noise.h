#pragma once
#include <span>

#include "core/vector.h"
#include "image/plane.h"

namespace ajar {

/// Impulse noise of a picture, in [0, 1]: |pixel − median of the window around it| per channel, the
/// largest of the channels, divided by the largest in the picture. A picture without any (black,
/// constant, of one pixel) is 0 everywhere. Linear in the picture: one firefly sets the scale for
/// all other pixels.
///
/// `pixels`: row by row, any number of channels side by side, of any unit; `window`: 3 or 5 pixels
/// wide and high. At the border the window is clipped; the median of an even number of values is
/// the mean of the two in the middle. A value that is not finite tells nothing: it has no noise,
/// and the medians around it are taken without it. Raises std::invalid_argument for another window,
/// or if the values are not whole pixels of an image of that size.
///
/// Source: Frolov, "Selective application of Metropolis Light Transport for hard sampling
/// illumination phenomena", who leaves open what happens at the border.
Plane impulse_noise(Vec2i size, std::span<const float> pixels, int window = 3);

}  // namespace ajar
