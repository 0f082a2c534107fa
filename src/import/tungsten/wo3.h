#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/desc/shape_data.h"

namespace ajar::tungsten {

/// A mesh whose triangles may have materials of their own.
struct Wo3Mesh {
  desc::Mesh mesh;
  std::vector<std::int32_t> materials;  ///< index into the bsdfs of the primitive; one per triangle
};

/// Reads a mesh in Tungsten's own format, little endian: the number of vertices (64 bits), of each
/// position, normal and texture coordinates (8 floats), the number of triangles (64 bits), of each
/// three vertices and a material (32 bits each). Numbers are not judged: see `validate_mesh`.
/// Raises SceneError, with `name` as its file, if the data ends too early.
Wo3Mesh read_wo3(std::string_view bytes, const std::string& name);

}  // namespace ajar::tungsten
