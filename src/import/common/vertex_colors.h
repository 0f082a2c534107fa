#pragma once
#include <span>
#include <string>

#include "scene/desc/shape_data.h"

namespace ajar {

/// A mesh whose texture coordinates lead to the colours of its vertices in an image.
struct PaintedMesh {
  desc::Mesh mesh;    ///< with three vertices of its own for each triangle
  std::string image;  ///< an OpenEXR file of linear floats
};

/// Colours of vertices as an image: bilinear texture lookups of it are the linear interpolation
/// between the corners of each triangle, exactly. `colors` are one per vertex, linear.
PaintedMesh painted(const desc::Mesh& mesh, std::span<const Vec3> colors);

}  // namespace ajar
