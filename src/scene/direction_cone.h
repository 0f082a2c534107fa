#pragma once
#include <algorithm>
#include <cmath>

#include "core/frame.h"
#include "core/vector.h"

namespace ajar {

/// All directions within `angle` of `axis`. For building data structures; nothing here is fast.
struct DirectionCone {
  Vec3 axis{0.F, 0.F, 1.F};  ///< unit
  float angle = -1.F;        ///< radians, up to π: the whole sphere; negative: no direction at all

  static DirectionCone whole_sphere() { return {Vec3(0.F, 0.F, 1.F), kPi}; }
  bool is_empty() const { return angle < 0.F; }
  bool is_whole_sphere() const { return angle >= kPi; }
};

/// Angle between unit vectors, exact for small and for large ones too.
inline float angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// The smallest cone around both. Source: Conty Estevez & Kulla 2018, algorithm 1.
inline DirectionCone unite(const DirectionCone& a, const DirectionCone& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  const float between = angle_between(a.axis, b.axis);
  if (std::min(between + b.angle, kPi) <= a.angle) return a;
  if (std::min(between + a.angle, kPi) <= b.angle) return b;
  const float angle = 0.5F * (a.angle + between + b.angle);
  if (angle >= kPi) return DirectionCone::whole_sphere();
  const Frame frame = Frame::around(a.axis, b.axis);
  const float turn = angle - a.angle;
  return {normalize(a.axis * std::cos(turn) + frame.x * std::sin(turn)), angle};
}

}  // namespace ajar
