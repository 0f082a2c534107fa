#pragma once
#include <optional>

#include "scene/shape/placement.h"

namespace ajar {

/// Largest coordinate in the world of rays that Embree can transform into the space of an instance;
/// 0 if there are none. Embree inverts the transform in single precision, as the adjugate over the
/// determinant, and coordinates there must not exceed `kMaxRayCoordinate` either. Empty if that
/// inverse would be nothing but rounding errors.
std::optional<double> max_ray_coordinate(const Placement& instance);

}  // namespace ajar
