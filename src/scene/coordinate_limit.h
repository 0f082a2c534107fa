#pragma once
#include <string>

#include "core/error.h"
#include "core/vector.h"

namespace ajar {

/// Largest coordinate of the origin of a ray, in the world and in the space of every instance.
/// Embree takes a tenth of the square root of the largest float, so that sums of squares are
/// finite. Farther out it drops geometry without a word, and where it was built with assertions, as
/// in Debian, a ray ends the program. Source: Embree 3, `FLT_LARGE`, 1.844e18.
inline constexpr float kMaxRayCoordinate = 1.84e18F;

/// Largest coordinate at which a scene may have surfaces, lights or the camera. Light from infinity
/// starts on disks around the sphere around the scene: up to 3.002 times as far out.
inline constexpr float kMaxCoordinate = 6e17F;

/// Smallest radius of a scene. Embree's test of triangles multiplies three lengths; of triangles a
/// thousand times smaller than the scene the product still has all its digits. A scene below it
/// gets a warning.
inline constexpr float kMinRadius = 1e-8F;

/// Raises SceneError, located at `where`, if `reach`, the largest coordinate of the object
/// described there, is more than `kMaxCoordinate` or not a number.
void check_reach(const SourceLocation& where, const std::string& what, double reach);

/// Largest coordinate of a box, of either sign; 0 if it is empty.
double reach_of(const Vec3d& low, const Vec3d& high);
double reach_of(const Box3& box);

}  // namespace ajar
