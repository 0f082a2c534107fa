#pragma once
#include <cmath>
#include <string_view>

#include "core/parameters.h"
#include "core/vector.h"
#include "scene/light/map.h"

/// How maps are spread over all directions.
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

/// One of them.
struct SphereProjection {
  Vec2 (*to_uv)(const Vec3& w);          ///< of vectors of any length, in [0, 1)²
  Vec3 (*to_direction)(const Vec2& uv);  ///< unit
  float (*solid_angle)(const Vec2& uv);  ///< dω / d(uv)
  MapEdge edge;
  MapFilter filter;
};
/// "longitude_latitude" or "equal_area".
const SphereProjection& sphere_projection(std::string_view name);
ParameterSpec sphere_projection_input();

}  // namespace ajar
