#pragma once
#include <memory>

#include "core/error.h"
#include "core/warnings.h"
#include "scene/desc/shape_data.h"

namespace ajar {

/// Refines a control mesh with Loop's rules (boundary rules of Hoppe et al.) and pushes the
/// vertices to the limit surface, with limit normals. As in pbrt-v3 normals point against the
/// winding of the control mesh. A mesh that is not an oriented manifold is returned unrefined, with
/// a warning. Raises SceneError for indices out of range. Source: Loop 1987; pbrt-v3, section 3.8.
std::shared_ptr<const desc::Mesh> subdivide(const desc::Mesh& control, int levels,
                                            const SourceLocation& where, Warnings& warnings);

/// Levels that `subdivide` makes: as wanted, or as many as end with 2^27 triangles at most.
int possible_levels(const desc::Mesh& control, int wanted);

}  // namespace ajar
