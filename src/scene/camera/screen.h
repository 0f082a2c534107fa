#pragma once
#include <optional>

#include "core/vector.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// The window of a camera plane that the image shows, and its raster. Source: pbrt-v3, section 6.2.
class Screen {
 public:
  /// Without `window` the shorter side spans [-1, 1] and the longer one `aspect` (default: of the
  /// resolution) times that. `scale` multiplies all of it. Raises SceneError, located at `where`,
  /// if the window is empty, not finite, or too large.
  Screen(const std::optional<desc::ScreenWindow>& window, const std::optional<float>& aspect,
         Vec2i resolution, float scale, const SourceLocation& where);

  /// From raster position / resolution to the camera plane.
  Vec2 to_plane(const Vec2& unit) const {
    return {corner_.x + unit.x * extent_.x, corner_.y + unit.y * extent_.y};
  }
  /// Raster position of a point of the camera plane; empty outside of the window. Rays that were
  /// sampled on the very border must find themselves again in spite of rounding, hence a slack of a
  /// millionth.
  std::optional<Vec2> to_raster(const Vec2& plane) const;
  /// Area of the window, in units of the camera plane.
  float area() const { return std::abs(extent_.x * extent_.y); }

 private:
  Vec2 corner_;  ///< top left
  Vec2 extent_;  ///< from there to the bottom right; y is usually negative
  Vec2 resolution_;
};

/// Raster position from position / resolution, clamped to the half-open image; empty if it is
/// farther out than rounding explains.
std::optional<Vec2> unit_to_raster(const Vec2& unit, const Vec2& resolution);

}  // namespace ajar
