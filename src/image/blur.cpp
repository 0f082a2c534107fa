#include "image/blur.h"

#include <stdexcept>

#include "image/plane.h"

namespace ajar {

std::vector<float> blurred(std::span<const float> rgb, Vec2i size, double sigma) {
  Plane plane(size);
  if (rgb.size() != 3 * plane.values.size()) {
    throw std::invalid_argument("blurred: the picture has another size");
  }
  const SeparableKernel kernel = gaussian_kernel(sigma);
  std::vector<float> result(rgb.size());
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t i = 0; i < plane.values.size(); ++i) plane.values[i] = rgb[3 * i + channel];
    const Plane filtered = filter_plane(plane, kernel);
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
      result[3 * i + channel] = filtered.values[i];
    }
  }
  return result;
}

Replicates blurred(const Replicates& replicates, Vec2i size, double sigma) {
  Replicates all;
  for (const std::vector<float>& replicate : replicates) {
    all.push_back(blurred(std::span<const float>(replicate), size, sigma));
  }
  return all;
}

}  // namespace ajar
