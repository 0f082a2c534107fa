#pragma once
#include <string>
#include <string_view>

#include "scene/desc/scene_desc.h"

namespace ajar {

/// Reads the geometry of all groups and objects of a Wavefront OBJ file as one mesh: `v`, `vt`,
/// `vn` and `f`; materials, curves and colours are skipped. Corners with the same three indices
/// become one vertex; polygons are fanned into triangles. Texture coordinates stay as they are, v
/// from the bottom row of an image, as textures have it; a corner without some has (0, 0). Normals
/// are kept if every corner has one. Numbers are not judged: see `validate_mesh`. Raises
/// SceneError, with `name` as its file, if a face refers to what the file does
/// not have before it, or if there are no faces.
desc::Mesh read_obj(std::string_view bytes, const std::string& name);

}  // namespace ajar
