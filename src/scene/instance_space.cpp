#include "scene/instance_space.h"

#include <algorithm>

#include "scene/coordinate_limit.h"

namespace ajar {

std::optional<double> max_ray_coordinate(const Placement& instance) {
  const Mat4& m = instance.to_world();
  double determinant = 0.0;
  double rounded = 0.0;  // the sum of the absolute values, by which the rounding errors go
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    determinant += m[0][i] * (m[1][j] * m[2][k] - m[1][k] * m[2][j]);
    rounded += std::abs(m[0][i]) * (std::abs(m[1][j] * m[2][k]) + std::abs(m[1][k] * m[2][j]));
  }
  determinant = std::abs(determinant);
  // Five roundings of half an ulp, 2⁻²⁴, would be a third of it.
  if (!(determinant > 0x1p-20 * rounded)) return std::nullopt;

  const Mat4& inverse = instance.to_object();
  double stretch = 0.0;  // scale of the largest coordinate of a vector, at most
  double largest = 0.0;
  for (int column = 0; column < 3; ++column) {
    double sum = 0.0;
    for (int row = 0; row < 3; ++row) {
      sum += std::abs(inverse[row][column]);
      largest = std::max(largest, std::abs(inverse[row][column]));
    }
    stretch = std::max(stretch, sum);
  }
  // A third of the determinant may be rounding errors, hence half of the limits.
  constexpr double kLimit = 0.5 * static_cast<double>(kMaxRayCoordinate);
  constexpr double kSmallest = 2.0 * static_cast<double>(std::numeric_limits<float>::min());
  constexpr double kLargest = 0.5 * static_cast<double>(std::numeric_limits<float>::max());
  if (determinant < kSmallest || determinant > kLargest || largest * determinant > kLargest ||
      stretch > kLimit) {
    return 0.0;
  }
  const double away = std::max({std::abs(m[3][0]), std::abs(m[3][1]), std::abs(m[3][2])});
  return std::max(0.0, kLimit / stretch - away);
}

}  // namespace ajar
