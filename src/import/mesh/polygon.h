#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.h"

namespace ajar {

/// Adds triangles that cover the polygon with these corners, by the numbers of the corners, in its
/// direction. Convex ones are fanned from the first corner, others cut ear by ear as seen along
/// their mean normal; polygons that intersect themselves, or have more than 500 corners, are fanned
/// as well. Source: Meisters 1975, "Polygons have ears".
void triangulate(std::span<const Vec3> corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace ajar
