#pragma once
#include <string>
#include <vector>

#include "core/error.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Makes sure that a mesh can be built: positions finite, indices in range, attributes as many as
/// positions; raises SceneError at `where` if not. Attributes that are not finite or too few are
/// dropped, and triangles without area, each with one line in `remarks`.
void validate_mesh(desc::Mesh& mesh, const SourceLocation& where,
                   std::vector<std::string>& remarks);

}  // namespace ajar
