#pragma once
#include <vector>

#include "core/warnings.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Makes sure that a mesh can be built: positions finite, indices in range, attributes as many as
/// positions; raises SceneError at `where` if not. Attributes that are not finite or too few are
/// dropped, and triangles without area, each with one of `remarks`, which have `where`, too. If
/// none is left, that is one more.
void validate_mesh(desc::Mesh& mesh, const SourceLocation& where, std::vector<Warning>& remarks);

}  // namespace ajar
