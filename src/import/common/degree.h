#pragma once
#include <numbers>

namespace ajar {

/// In radians.
inline constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace ajar
