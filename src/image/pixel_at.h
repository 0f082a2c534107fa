#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/vector.h"

namespace ajar {

/// Index, row by row over `pixels` (min and max inclusive), of the pixel that a raster position
/// lies in; beyond the border, of the nearest.
inline std::size_t pixel_at(const Box2i& pixels, const Vec2& raster) {
  const int x = std::clamp(static_cast<int>(std::floor(raster.x)), pixels.min.x, pixels.max.x);
  const int y = std::clamp(static_cast<int>(std::floor(raster.y)), pixels.min.y, pixels.max.y);
  const int width = pixels.max.x - pixels.min.x + 1;
  return static_cast<std::size_t>(y - pixels.min.y) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(x - pixels.min.x);
}

}  // namespace ajar
