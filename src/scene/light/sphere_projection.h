#pragma once
#include <string_view>

#include "core/parameters.h"
#include "core/sphere_mapping.h"
#include "core/vector.h"
#include "scene/light/map.h"

/// How maps are spread over all directions (core/sphere_mapping.h).
namespace ajar {

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
