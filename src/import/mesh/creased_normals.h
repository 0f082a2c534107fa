#pragma once
#include "scene/desc/shape_data.h"

namespace ajar {

/// The given triangles with new normals: at each corner the mean of those of the triangles that
/// meet there, weighted by their areas, whose angle to its own has at least the cosine `cos_limit`.
/// Corners of equal position meet. `mesh` must be valid (`validate_mesh`).
desc::Mesh with_creased_normals(const desc::Mesh& mesh, float cos_limit);

}  // namespace ajar
