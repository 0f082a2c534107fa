#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/vector.h"

/// A trilinear field is a cubic polynomial along a ray within a cell: its integral is known, and
/// inverted. Values are numbers, or three of them.
namespace ajar::cubic {

template <typename Value>
Value lerp(const Value& a, const Value& b, double t) {
  return a + (b - a) * t;
}

/// At a place in a cell, each coordinate in [0, 1]; of the corners, x varies fastest, then y.
template <typename Value>
Value trilinear(const std::array<Value, 8>& c, const Vec3d& p) {
  const Value front = lerp(lerp(c[0], c[1], p.x), lerp(c[2], c[3], p.x), p.y);
  const Value back = lerp(lerp(c[4], c[5], p.x), lerp(c[6], c[7], p.x), p.y);
  return lerp(front, back, p.z);
}

/// Gauss quadrature with two points, which is exact for cubic polynomials.
template <typename Function>
auto integral(const Function& f, double from, double to) {
  const double half = 0.5 * (to - from);
  const double middle = from + half;
  const double offset = half / std::numbers::sqrt3;
  return (f(middle - offset) + f(middle + offset)) * half;
}

/// More steps than bisection alone needs.
inline constexpr int kMaxSteps = 100;

/// Where the integral of `f`, which is not negative, from `from` on is `amount`: between 0 and
/// `whole`, that up to `to`. Newton's method, and bisection where that leads out of the bracket.
template <typename Function>
double invert_integral(const Function& f, double from, double to, double whole, double amount) {
  double low = from;
  double high = to;
  double t = lerp(from, to, amount / whole);
  const double precision = (to - from) * std::numeric_limits<float>::epsilon() * 1e-2;
  for (int i = 0; i < kMaxSteps && high - low > precision; ++i) {
    const double excess = integral(f, from, t) - amount;
    (excess > 0.0 ? high : low) = t;
    const double slope = f(t);
    double next = slope > 0.0 ? t - excess / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double moved = std::abs(next - t);
    t = next;
    if (moved <= precision) break;
  }
  return t;
}

}  // namespace ajar::cubic
