#include "scene/camera/screen.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "scene/coordinate_limit.h"

namespace ajar {

Screen::Screen(const std::optional<desc::ScreenWindow>& window, const std::optional<float>& aspect,
               Vec2i resolution, float scale, const SourceLocation& where)
    : resolution_(static_cast<float>(resolution.x), static_cast<float>(resolution.y)) {
  const float ratio = aspect.value_or(resolution_.x / resolution_.y);
  const float x = std::max(ratio, 1.F);
  const float y = std::max(1.F / ratio, 1.F);
  const desc::ScreenWindow shown = window.value_or(desc::ScreenWindow{-x, x, -y, y});
  corner_ = Vec2(shown.x_min, shown.y_max) * scale;
  extent_ = Vec2(shown.x_max - shown.x_min, shown.y_min - shown.y_max) * scale;
  if (!(ratio > 0.F && std::isfinite(area()) && area() > 0.F)) {
    throw SceneError(where, "the camera's screen window is empty or not finite");
  }
  const Vec2 end = corner_ + extent_;
  check_reach(where, "the camera's screen window",
              reach_of({corner_.x, corner_.y, 0.0}, {end.x, end.y, 0.0}));
}

std::optional<Vec2> Screen::to_raster(const Vec2& plane) const {
  return unit_to_raster({(plane.x - corner_.x) / extent_.x, (plane.y - corner_.y) / extent_.y},
                        resolution_);
}

std::optional<Vec2> unit_to_raster(const Vec2& unit, const Vec2& resolution) {
  constexpr float kSlack = 1e-6F;
  const auto inside = [](float x) { return x >= -kSlack && x < 1.F + kSlack; };
  if (!inside(unit.x) || !inside(unit.y)) return std::nullopt;
  const auto scaled = [](float x, float size) {
    return std::clamp(x, 0.F, kOneMinusEpsilon) * size;
  };
  return Vec2(scaled(unit.x, resolution.x), scaled(unit.y, resolution.y));
}

}  // namespace ajar
