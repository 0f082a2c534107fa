#pragma once
#include <string>
#include <string_view>

#include "scene/desc/shape_data.h"

namespace ajar {

/// Reads a mesh in the STL format, ASCII or binary. The normals of the file are ignored: they are
/// those of the triangles, which turn counterclockwise seen from outside. Numbers are not judged:
/// see `validate_mesh`. Raises SceneError, with `name` as its file and, of ASCII, line and column,
/// if the data is not complete. Source: 3D Systems 1989, StereoLithography Interface Specification.
desc::Mesh read_stl(std::string_view bytes, const std::string& name);

}  // namespace ajar
