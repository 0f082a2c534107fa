#pragma once
#include <limits>

#include "core/vector.h"

namespace ajar {

struct Ray {
  Vec3 origin;
  Vec3 direction;  ///< unit
  float t_max = std::numeric_limits<float>::infinity();
};

}  // namespace ajar
