#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/desc/shape_data.h"

namespace ajar {

/// A mesh, and the colours of its vertices, linear, if the file has some.
struct StlContents {
  desc::Mesh mesh;
  std::vector<Vec3> colors;
};

/// Reads a mesh in the STL format, ASCII or binary. The normals of the file are ignored: they are
/// those of the triangles, which turn counterclockwise seen from outside. Numbers are not judged:
/// see `validate_mesh`. Raises SceneError, with `name` as its file and, of ASCII, line and column,
/// if the data is not complete. Colours are those of a display, in the two bytes behind a triangle
/// of a binary file: five bits for each lane, and one that says whether they count. Blue comes
/// first and the bit is 1, or, if the header has "COLOR=" and the colour of the rest in four bytes,
/// red comes first and the bit is 0. Sources: 3D Systems 1989, StereoLithography Interface
/// Specification; for colours, what VisCAM and Materialise's Magics write.
StlContents read_stl(std::string_view bytes, const std::string& name);

}  // namespace ajar
