#pragma once
#include <span>
#include <vector>

#include "core/plane.h"
#include "core/vector.h"

/// Filters of one channel of an image.
namespace ajar {

/// Weights of a filter that is a product of one function of x and one of y; an odd number of each,
/// the middle one at the pixel itself. They are applied as a correlation: weight i belongs to the
/// pixel at offset i − radius.
struct SeparableKernel {
  std::vector<float> x;
  std::vector<float> y;
};

/// Filters a plane; beyond the border the pixels of the border repeat. On all threads.
Plane filter_plane(const Plane& plane, const SeparableKernel& kernel);

/// A Gaussian of σ pixels in both directions, whose weights sum to 1; cut at 4 σ.
SeparableKernel gaussian_kernel(double sigma);

/// The mean of a square of 2 · radius + 1 pixels.
SeparableKernel box_kernel(int radius);

/// The mean of each block of 2×2 pixels, of fewer at the end of odd sizes.
Plane halved(const Plane& plane);
/// Twice as large, linear in between: of a size whose half `plane` has.
Plane doubled(const Plane& plane, Vec2i size);

/// The channels of an interleaved picture.
std::vector<Plane> planes_of(Vec2i size, std::span<const float> interleaved);
/// The picture of these channels.
std::vector<float> interleaved(std::span<const Plane> planes);

/// exp(−x²/(2σ²)) for x = −radius … radius, not normalised. σ in pixels.
std::vector<double> gaussian_weights(int radius, double sigma);

}  // namespace ajar
