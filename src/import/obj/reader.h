#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "import/obj/library.h"
#include "scene/desc/shape_data.h"

namespace ajar::obj {

/// All faces of a file that have one material, and texture coordinates and normals, or not.
struct Part {
  std::string material;  ///< empty if none is named
  SourceLocation where;  ///< of its first face
  desc::Mesh mesh;
};

/// Reads a Wavefront file, its materials into `library`. Polygons are fanned into triangles.
/// Numbers are not judged: see `validate_mesh`. Raises SceneError, with file and line, for faces
/// of vertices that are not there, and if there are no faces.
std::vector<Part> read_parts(std::string_view text, const std::string& name, Library& library);

}  // namespace ajar::obj
