#include "image/plane.h"

#include <algorithm>
#include <cmath>

#include "core/parallel_for.h"

namespace ajar {

namespace {
/// Correlation of one row or column: `read(i)` gives the value at i of `count`, `write(i, v)` takes
/// the result.
template <typename Read, typename Write>
void filter_line(int count, std::span<const float> weights, Read read, Write write) {
  const int radius = static_cast<int>(weights.size() / 2);
  for (int i = 0; i < count; ++i) {
    float sum = 0.F;
    for (int offset = -radius; offset <= radius; ++offset) {
      sum += weights[static_cast<std::size_t>(offset + radius)] *
             read(std::clamp(i + offset, 0, count - 1));
    }
    write(i, sum);
  }
}
}  // namespace

Plane::Plane(Vec2i plane_size)
    : size(plane_size),
      values(static_cast<std::size_t>(plane_size.x) * static_cast<std::size_t>(plane_size.y)) {}

Plane filter_plane(const Plane& plane, const SeparableKernel& kernel) {
  Plane rows(plane.size);
  parallel_for(plane.size.y, [&](int y) {
    filter_line(
        plane.size.x, kernel.x, [&](int x) { return plane.at(x, y); },
        [&](int x, float value) { rows.at(x, y) = value; });
  });
  Plane result(plane.size);
  // Row by row again, so that memory is read in order.
  const int radius = static_cast<int>(kernel.y.size() / 2);
  parallel_for(plane.size.y, [&](int y) {
    for (int offset = -radius; offset <= radius; ++offset) {
      const float weight = kernel.y[static_cast<std::size_t>(offset + radius)];
      const int source = std::clamp(y + offset, 0, plane.size.y - 1);
      for (int x = 0; x < plane.size.x; ++x) result.at(x, y) += weight * rows.at(x, source);
    }
  });
  return result;
}

std::vector<double> gaussian_weights(int radius, double sigma) {
  std::vector<double> weights;
  for (int x = -radius; x <= radius; ++x) weights.push_back(std::exp(-x * x / (2 * sigma * sigma)));
  return weights;
}

}  // namespace ajar
