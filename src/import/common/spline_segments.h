#pragma once
#include <array>

namespace ajar {

/// Between `a` and `b`, points or numbers.
template <typename Value>
Value lerp(float t, const Value& a, const Value& b) {
  return a * (1.F - t) + b * t;
}

/// Control points of a cubic Bézier segment.
template <typename Value>
using CubicSegment = std::array<Value, 4>;

/// Degree elevation of a quadratic Bézier segment.
template <typename Value>
CubicSegment<Value> elevated(const Value& a, const Value& b, const Value& c) {
  return {a, lerp(2.F / 3.F, a, b), lerp(1.F / 3.F, b, c), c};
}

/// Segment of a uniform quadratic B-spline with control points p[0..2].
template <typename Value>
CubicSegment<Value> quadratic_spline_segment(const Value* p) {
  return elevated(lerp(0.5F, p[0], p[1]), p[1], lerp(0.5F, p[1], p[2]));
}

/// Segment of a uniform cubic B-spline with control points p[0..3], by blossoming: neighbours
/// compute their common point from the same numbers, so that it has the same bits in both.
template <typename Value>
CubicSegment<Value> cubic_spline_segment(const Value* p) {
  const Value p122 = lerp(2.F / 3.F, p[0], p[1]);
  const Value p223 = lerp(1.F / 3.F, p[1], p[2]);
  const Value p233 = lerp(2.F / 3.F, p[1], p[2]);
  const Value p334 = lerp(1.F / 3.F, p[2], p[3]);
  return {lerp(0.5F, p122, p223), p223, p233, lerp(0.5F, p233, p334)};
}

}  // namespace ajar
