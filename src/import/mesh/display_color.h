#pragma once
#include <algorithm>

#include "color/srgb.h"
#include "core/vector.h"

namespace ajar {

/// The linear value of a display colour, each lane from 0 to 1: other values are clamped, and NaN
/// is 0. Vertices of files without a convention have such colours: they come from the bytes of
/// photographs.
inline Vec3 from_display(Vec3 color) {
  for (int lane = 0; lane < 3; ++lane) {
    // Written so that NaN becomes 0.
    color[lane] = color[lane] > 0.F ? linear_from_srgb(std::min(color[lane], 1.F)) : 0.F;
  }
  return color;
}

}  // namespace ajar
