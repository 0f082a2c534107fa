#include "import/common/transforms.h"

#include <algorithm>
#include <cmath>

namespace ajar {
namespace {

std::optional<Vec3d> direction_of(const Vec3d& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0) || !std::isfinite(largest)) return std::nullopt;
  const Vec3d scaled = v / largest;
  return scaled / std::sqrt(scaled.dot(scaled));
}

Mat4 from_rows(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& origin) {
  return {x.x, x.y, x.z, 0.0, y.x,      y.y,      y.z,      0.0,
          z.x, z.y, z.z, 0.0, origin.x, origin.y, origin.z, 1.0};
}

/// Exponent of the largest entry of a group of rows; empty if all are zero.
template <std::size_t Rows>
std::optional<int> largest_exponent(const double (*rows)[4]) {
  double largest = 0.0;
  for (std::size_t r = 0; r < Rows; ++r) {
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(rows[r][c]));
  }
  if (!(largest > 0.0)) return std::nullopt;
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

/// Rounds a group of rows to multiples of 2^-40 of the power of two above its largest entry.
template <std::size_t Rows>
void round_group(double (*rows)[4]) {
  std::optional<int> exponent = largest_exponent<Rows>(rows);
  while (exponent) {
    for (std::size_t r = 0; r < Rows; ++r) {
      for (int c = 0; c < 3; ++c) {
        const double steps = std::nearbyint(std::ldexp(rows[r][c], 40 - *exponent));
        rows[r][c] = std::ldexp(steps, *exponent - 40) + 0.0;  // + 0 makes -0 positive
      }
    }
    // Rounding up to a power of two makes the steps larger: once more with those.
    const std::optional<int> rounded = largest_exponent<Rows>(rows);
    if (rounded == exponent) break;
    exponent = rounded;
  }
}

}  // namespace

Mat4 translation(const Vec3d& offset) {
  return from_rows({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, offset);
}

Mat4 scaling(const Vec3d& factors) {
  return from_rows({factors.x, 0.0, 0.0}, {0.0, factors.y, 0.0}, {0.0, 0.0, factors.z},
                   {0.0, 0.0, 0.0});
}

std::optional<Mat4> rotation(double degrees, const Vec3d& axis) {
  const std::optional<Vec3d> a = direction_of(axis);
  if (!a) return std::nullopt;
  const double radians = degrees * (3.14159265358979323846 / 180.0);
  const double sine = std::sin(radians);
  const double cosine = std::cos(radians);
  // Rodrigues' formula: the rows are the images of the unit vectors.
  const auto image = [&](const Vec3d& v) {
    return v * cosine + a->cross(v) * sine + *a * (a->dot(v) * (1.0 - cosine));
  };
  return from_rows(image({1.0, 0.0, 0.0}), image({0.0, 1.0, 0.0}), image({0.0, 0.0, 1.0}),
                   {0.0, 0.0, 0.0});
}

std::optional<Mat4> look_at(const Vec3d& eye, const Vec3d& target, const Vec3d& up) {
  const std::optional<Vec3d> forward = direction_of(target - eye);
  const std::optional<Vec3d> upward = direction_of(up);
  if (!forward || !upward) return std::nullopt;
  const Vec3d sideways = upward->cross(*forward);
  if (std::sqrt(sideways.dot(sideways)) < 1e-12) return std::nullopt;
  const Vec3d right = *direction_of(sideways);
  return inverse(from_rows(right, forward->cross(right), *forward, eye));
}

std::optional<Mat4> z_to(const Vec3d& direction) {
  const std::optional<Vec3d> z = direction_of(direction);
  if (!z) return std::nullopt;
  // Duff et al. 2017, Building an orthonormal basis, revisited.
  const double sign = std::copysign(1.0, z->z);
  const double a = -1.0 / (sign + z->z);
  const double b = z->x * z->y * a;
  return from_rows({1.0 + sign * z->x * z->x * a, sign * b, -sign * z->x},
                   {b, sign + z->y * z->y * a, -z->y}, *z, {0.0, 0.0, 0.0});
}

std::optional<Mat4> inverse(const Mat4& m) {
  if (!is_finite(m)) return std::nullopt;
  try {
    const Mat4 result = m.inverse(true);
    if (is_finite(result)) return result;
  } catch (const std::exception&) {  // Imath's way to say that the matrix is singular
  }
  return std::nullopt;
}

std::optional<Mat4> rounded_inverse(const Mat4& m) {
  std::optional<Mat4> result = inverse(m);
  if (result) {
    round_group<3>(&result->x[0]);
    round_group<1>(&result->x[3]);
  }
  return result;
}

bool is_finite(const Mat4& m) {
  for (const auto& row : m.x) {
    for (const double value : row) {
      if (!std::isfinite(value)) return false;
    }
  }
  return true;
}

}  // namespace ajar
