#pragma once
#include <algorithm>
#include <cmath>

namespace ajar {

/// Greatest integer not above x, for coordinates of any size (NaN gives 0).
inline int floor_to_int(float x) {
  constexpr float kLimit = 1e9F;
  return static_cast<int>(std::floor(std::isnan(x) ? 0.F : std::clamp(x, -kLimit, kLimit)));
}

}  // namespace ajar
