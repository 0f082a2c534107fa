#pragma once
#include "core/vector.h"

/// Maps between all directions and [0, 1)².
namespace ajar {

/// Latitude and longitude as in pbrt-v3: v = θ/π from +z, u = φ/2π from +x toward +y.
namespace lat_long {
Vec2 to_uv(const Vec3& w);
Vec3 to_direction(const Vec2& uv);
}  // namespace lat_long

/// A square of which every part covers as much solid angle as any other of its size, as in pbrt-v4:
/// +z in the middle, −z at the corners, u along x and v along y. Source: Clarberg 2008, "Fast
/// equal-area mapping of the (hemi)sphere using SIMD".
namespace equal_area {
Vec2 to_uv(const Vec3& w);
Vec3 to_direction(const Vec2& uv);
}  // namespace equal_area

}  // namespace ajar
