#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "import/mesh/ply_header.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Reads a mesh in Stanford PLY format: ascii or binary of either byte order, optionally compressed
/// by gzip. Takes x y z, nx ny nz, and u v | s t | texture_u texture_v | texture_s texture_t of the
/// element `vertex`, and the list `vertex_indices` or `vertex_index` of the element `face`,
/// whose polygons become triangles (`polygon.h`), or of `tristrips`. Everything else is skipped.
/// Numbers are not judged: see `validate_mesh`. Raises SceneError, with `name` as its file, if the
/// data is not a complete PLY file.
desc::Mesh read_ply(std::string_view bytes, const std::string& name);

/// A mesh with parts that no mesh of a scene has: colours of its vertices, display-encoded in the
/// file and linear here, if it has any; images that remarks of the header name; and the skipped
/// parts of the file, "flags" of a face or "edge" for an element.
struct PlyContents {
  desc::Mesh mesh;
  std::vector<Vec3> colors;
  std::vector<PlyImage> images;
  std::vector<std::string> skipped;
};
PlyContents read_ply_contents(std::string_view bytes, const std::string& name);

/// Little-endian binary PLY of positions, normals, uvs and indices (tangents have no place in PLY).
std::string write_ply(const desc::Mesh& mesh);

}  // namespace ajar
