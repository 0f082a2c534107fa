#pragma once
#include <string_view>

#include "core/parameters.h"
#include "core/sphere_mapping.h"
#include "core/vector.h"
#include "scene/light/map.h"

/// Parameterisations of the sphere for maps (core/sphere_mapping.h).
namespace ajar {

/// One of them.
struct SphereProjection {
  Vec2 (*to_uv)(const Vec3& w);          ///< maps vectors of any length to [0, 1)²
  Vec3 (*to_direction)(const Vec2& uv);  ///< unit
  float (*solid_angle)(const Vec2& uv);  ///< dω / d(uv)
  MapEdge edge;
  MapFilter filter;
};
/// "longitude_latitude" or "equal_area".
const SphereProjection& sphere_projection(std::string_view name);
ParameterSpec sphere_projection_input();

}  // namespace ajar
