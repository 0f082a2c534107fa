#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/vector.h"

namespace ajar {

/// Real roots of a t² + 2 b t + c = 0 in ascending order; their number is returned. Stable when b²
/// ≫ ac.
inline int solve_quadratic(double a, double b, double c, double t[2]) {
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0.0)) return 0;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  int count = 0;
  if (q != 0.0) t[count++] = c / q;
  if (a != 0.0 && std::isfinite(q / a)) t[count++] = q / a;
  if (count == 2 && t[0] > t[1]) std::swap(t[0], t[1]);
  return count;
}

/// ∫₀ˣ √(a y² + 2 b y + c) dy for a polynomial that is nowhere negative.
inline double integral_of_sqrt_quadratic(double a, double b, double c, double x) {
  const auto value = [=](double y) { return std::sqrt(std::max(0.0, (a * y + 2.0 * b) * y + c)); };
  if (a <= 1e-14 * (std::abs(b) + c)) {
    // Almost constant (cylinders): Simpson's rule is exact to rounding.
    return x / 6.0 * (value(0.0) + 4.0 * value(0.5 * x) + value(x));
  }
  const double root = std::sqrt(a);
  const double rest = std::max(0.0, c - b * b / a);
  const auto primitive = [&](double y) {
    const double s = a * y + b;
    const double f = value(y);
    const double logarithm =
        rest > 1e-14 * c ? std::asinh(s / std::sqrt(a * rest)) * rest / (2.0 * root) : 0.0;
    return s * f / (2.0 * a) + logarithm;
  };
  return primitive(x) - primitive(0.0);
}

/// Derivatives of the unit normal from first and second derivatives of the position (Weingarten
/// equations). Zero where the parameterisation is singular. Source: pbrt-v3, section 3.2.6.
inline void weingarten(const Vec3d& dpdu, const Vec3d& dpdv, const Vec3d& n, const Vec3d& d2uu,
                       const Vec3d& d2uv, const Vec3d& d2vv, Vec3d& dndu, Vec3d& dndv) {
  const double first_uu = dpdu.dot(dpdu);
  const double first_uv = dpdu.dot(dpdv);
  const double first_vv = dpdv.dot(dpdv);
  const double second_uu = n.dot(d2uu);
  const double second_uv = n.dot(d2uv);
  const double second_vv = n.dot(d2vv);
  const double scale = 1.0 / (first_uu * first_vv - first_uv * first_uv);
  dndu = dndv = Vec3d(0.0);
  if (!std::isfinite(scale)) return;
  dndu = dpdu * ((second_uv * first_uv - second_uu * first_vv) * scale) +
         dpdv * ((second_uu * first_uv - second_uv * first_uu) * scale);
  dndv = dpdu * ((second_vv * first_uv - second_uv * first_vv) * scale) +
         dpdv * ((second_uv * first_uv - second_vv * first_uu) * scale);
}

}  // namespace ajar
