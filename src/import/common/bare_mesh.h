#pragma once
#include <span>
#include <string>

#include "import/common/scene_file.h"
#include "import/common/studio.h"

namespace ajar {

/// Look of a bare mesh; neutral by default.
struct Paint {
  std::span<const Vec3> colors = {};  ///< vertex colours, linear
  std::string image = {};             ///< for its texture coordinates, resolved; before `colors`
};

/// A mesh that is all there is in `file`, in a studio. Raises SceneError, as `validate_mesh` does,
/// if it cannot be used.
desc::SceneDesc scene_of_mesh(desc::Mesh mesh, const Paint& paint, const SceneFile& file,
                              Warnings& warnings, UpAxis up);

}  // namespace ajar
