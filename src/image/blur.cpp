#include "image/blur.h"

#include <stdexcept>

#include "image/plane.h"

namespace ajar {

std::vector<float> blurred(std::span<const float> rgb, Vec2i size, double sigma) {
  if (rgb.size() != 3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {
    throw std::invalid_argument("blurred: the picture has another size");
  }
  const SeparableKernel kernel = gaussian_kernel(sigma);
  std::vector<Plane> planes = planes_of(size, rgb);
  for (Plane& plane : planes) plane = filter_plane(plane, kernel);
  return interleaved(planes);
}

Replicates blurred(const Replicates& replicates, Vec2i size, double sigma) {
  Replicates all;
  for (const std::vector<float>& replicate : replicates) {
    all.push_back(blurred(std::span<const float>(replicate), size, sigma));
  }
  return all;
}

}  // namespace ajar
