#include "image/plane.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/parallel_for.h"

namespace ajar {

namespace {
/// The row `y`, with `radius` copies of its ends on either side.
std::vector<float> padded_row(const Plane& plane, int y, int radius) {
  std::vector<float> row;
  row.reserve(static_cast<std::size_t>(plane.size.x) + 2 * static_cast<std::size_t>(radius));
  for (int x = -radius; x < plane.size.x + radius; ++x) {
    row.push_back(plane.at(std::clamp(x, 0, plane.size.x - 1), y));
  }
  return row;
}

/// result[x] += weight · values[x] for x in [0, count).
void add_scaled(float* result, const float* values, float weight, int count) {
  for (int x = 0; x < count; ++x) result[x] += weight * values[x];
}
}  // namespace

Plane filter_plane(const Plane& plane, const SeparableKernel& kernel) {
  // Weight by weight, and row by row in both directions: the compiler makes vectors of the loops.
  const int count = plane.size.x;
  const int x_radius = static_cast<int>(kernel.x.size() / 2);
  Plane rows(plane.size);
  parallel_for(plane.size.y, [&](int y) {
    const std::vector<float> row = padded_row(plane, y, x_radius);
    for (std::size_t i = 0; i < kernel.x.size(); ++i) {
      add_scaled(&rows.at(0, y), row.data() + i, kernel.x[i], count);
    }
  });
  const int y_radius = static_cast<int>(kernel.y.size() / 2);
  Plane result(plane.size);
  parallel_for(plane.size.y, [&](int y) {
    for (std::size_t i = 0; i < kernel.y.size(); ++i) {
      const int source = std::clamp(y + static_cast<int>(i) - y_radius, 0, plane.size.y - 1);
      add_scaled(&result.at(0, y), &rows.at(0, source), kernel.y[i], count);
    }
  });
  return result;
}

std::vector<double> gaussian_weights(int radius, double sigma) {
  std::vector<double> weights;
  for (int x = -radius; x <= radius; ++x) weights.push_back(std::exp(-x * x / (2 * sigma * sigma)));
  return weights;
}

SeparableKernel gaussian_kernel(double sigma) {
  const std::vector<double> weights =
      gaussian_weights(static_cast<int>(std::ceil(4.0 * sigma)), sigma);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  SeparableKernel kernel;
  for (const double weight : weights) kernel.x.push_back(static_cast<float>(weight / sum));
  kernel.y = kernel.x;
  return kernel;
}

SeparableKernel box_kernel(int radius) {
  const int width = 2 * radius + 1;
  const std::vector<float> weights(static_cast<std::size_t>(width),
                                   1.F / static_cast<float>(width));
  return {weights, weights};
}

Plane halved(const Plane& plane) {
  Plane half({(plane.size.x + 1) / 2, (plane.size.y + 1) / 2});
  parallel_for(half.size.y, [&](int y) {
    const int below = std::min(2 * y + 1, plane.size.y - 1);
    for (int x = 0; x < half.size.x; ++x) {
      const int right = std::min(2 * x + 1, plane.size.x - 1);
      half.at(x, y) = 0.25F * (plane.at(2 * x, 2 * y) + plane.at(right, 2 * y) +
                               plane.at(2 * x, below) + plane.at(right, below));
    }
  });
  return half;
}

Plane doubled(const Plane& plane, Vec2i size) {
  // The second nearest pixel of the half picture, along one axis.
  const auto beside = [](int at, int end) {
    return std::clamp(at / 2 + (at % 2 == 0 ? -1 : 1), 0, end - 1);
  };
  Plane result(size);
  parallel_for(size.y, [&](int y) {
    const int near_y = y / 2;
    const int far_y = beside(y, plane.size.y);
    for (int x = 0; x < size.x; ++x) {
      const int near_x = x / 2;
      const int far_x = beside(x, plane.size.x);
      result.at(x, y) = (9.F * plane.at(near_x, near_y) + 3.F * plane.at(far_x, near_y) +
                         3.F * plane.at(near_x, far_y) + plane.at(far_x, far_y)) /
                        16.F;
    }
  });
  return result;
}

std::vector<Plane> planes_of(Vec2i size, std::span<const float> interleaved) {
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  if (pixels == 0 || interleaved.size() % pixels != 0) {
    throw std::invalid_argument("planes: sizes do not fit");
  }
  std::vector<Plane> planes(interleaved.size() / pixels, Plane(size));
  for (std::size_t i = 0; i < interleaved.size(); ++i) {
    planes[i % planes.size()].values[i / planes.size()] = interleaved[i];
  }
  return planes;
}

std::vector<float> interleaved(std::span<const Plane> planes) {
  std::vector<float> values(planes.size() * planes.front().values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = planes[i % planes.size()].values[i / planes.size()];
  }
  return values;
}

}  // namespace ajar
