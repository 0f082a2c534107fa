#pragma once
#include <span>

#include "import/common/scene_file.h"
#include "import/common/studio.h"

namespace ajar {

/// A mesh that is all there is in `file`, in a studio, with `colors` of its vertices (linear;
/// empty: neutral). Raises SceneError, as `validate_mesh` does, if it cannot be used.
desc::SceneDesc scene_of_mesh(desc::Mesh mesh, std::span<const Vec3> colors, const SceneFile& file,
                              Warnings& warnings, UpAxis up);

}  // namespace ajar
