#pragma once
#include <limits>

#include "core/vector.h"

namespace ajar {

struct Ray {
  Vec3 origin;
  Vec3 direction;  ///< unit
  float t_max = std::numeric_limits<float>::infinity();
  /// Goes through surfaces that emit as if they were interfaces: seen by a camera that hides
  /// lights.
  bool passes_lights = false;
};

/// The ray between two points that were already moved off their surfaces; it stops a few roundings
/// short.
inline Ray ray_between(const Vec3& from, const Vec3& to) {
  const Vec3 difference = to - from;
  const float distance = length(difference);
  return {from, difference / distance, distance * (1.F - 0x1p-20F)};
}

}  // namespace ajar
