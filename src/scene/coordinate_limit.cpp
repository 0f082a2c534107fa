#include "scene/coordinate_limit.h"

#include <algorithm>

#include "core/number_text.h"

namespace ajar {

void check_reach(const SourceLocation& where, const std::string& what, double reach) {
  if (reach <= static_cast<double>(kMaxCoordinate)) return;
  if (!std::isfinite(reach)) throw SceneError(where, what + " is not finite");
  throw SceneError(where, what + " has coordinates of " + number_text(reach) +
                              ", but no more than " + number_text(double{kMaxCoordinate}) +
                              " can be rendered: scale the scene down");
}

double reach_of(const Vec3d& low, const Vec3d& high) {
  double reach = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (const double x : {low[i], high[i]}) {
      if (std::isnan(x)) return x;
      reach = std::max(reach, std::abs(x));
    }
  }
  return reach;
}

double reach_of(const Box3& box) {
  return box.isEmpty() ? 0.0 : reach_of(Vec3d(box.min), Vec3d(box.max));
}

}  // namespace ajar
