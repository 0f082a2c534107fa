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

}  // namespace ajar
