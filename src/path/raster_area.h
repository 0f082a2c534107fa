#pragma once
#include <algorithm>

#include "core/vector.h"

namespace ajar {

/// A rectangle of raster positions, pixels of the full image: where paths may land.
struct RasterArea {
  Vec2 low{0.F, 0.F};
  Vec2 size{1.F, 1.F};

  Vec2 raster(const Vec2& u) const { return low + u * size; }
  /// The inverse, within [0, 1).
  Vec2 place(const Vec2& at) const {
    const auto within = [](float u) { return std::clamp(u, 0.F, 1.F - 0x1p-24F); };
    const Vec2 offset = at - low;
    return {within(offset.x / size.x), within(offset.y / size.y)};
  }
  bool contains(const Vec2& raster) const {
    return raster.x >= low.x && raster.y >= low.y && raster.x < low.x + size.x &&
           raster.y < low.y + size.y;
  }
  /// Pixels².
  double area() const { return static_cast<double>(size.x) * static_cast<double>(size.y); }
};

/// Area of the full image, pixels²: densities over it are those over the unit square, divided by
/// this.
inline double image_area(const Vec2i& resolution) {
  return static_cast<double>(resolution.x) * static_cast<double>(resolution.y);
}

}  // namespace ajar
