#pragma once
#include <string>
#include <string_view>

#include "scene/desc/scene_desc.h"

namespace ajar::mitsuba {

/// Reads one of the meshes of a `.serialized` file, of version 3 or 4. Vertex colours are skipped.
/// A mesh that says that it is not smooth has no normals. Numbers are not judged: see
/// `validate_mesh`. Raises SceneError, with `name` as its file, if there is no such mesh or it is
/// not complete; IoError if it needs more memory than there is. Source: Mitsuba 0.6 manual,
/// section 8.2.4.
desc::Mesh read_serialized(std::string_view bytes, const std::string& name, long long index);

}  // namespace ajar::mitsuba
