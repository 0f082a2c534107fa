#pragma once
#include <cstdint>
#include <vector>

#include "core/vector.h"

/// Bulk data of shapes, typed: a mesh has no name, unit and range for each of its numbers. A
/// parameter of the type Mesh or Curves holds all of it, shared, so that a copy of a description
/// does not copy geometry.
namespace ajar::desc {

struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;   ///< per vertex, or empty
  std::vector<Vec3> tangents;  ///< per vertex, or empty
  /// Beside tangents: across is this (1 or −1) times the normal × tangent; per vertex, or empty:
  /// across is where the texture coordinates have it.
  std::vector<std::int8_t> handedness;
  std::vector<Vec2> uvs;                       ///< per vertex, or empty
  std::vector<Imath::Vec3<unsigned>> indices;  ///< one per triangle, each < positions.size()
};

/// One cubic Bézier segment per group of four control points.
struct Curves {
  std::vector<Vec3> control_points;  ///< 4 per segment
  std::vector<float> widths;         ///< one per control point
  std::vector<Vec3> normals;         ///< ribbons: one per control point
};

}  // namespace ajar::desc
