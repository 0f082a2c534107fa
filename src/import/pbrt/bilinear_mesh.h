#pragma once
#include <optional>

#include "import/pbrt/context.h"
#include "import/pbrt/parameter_list.h"

namespace ajar::pbrt {

/// `Shape "bilinearmesh"` of pbrt-v4 as triangles.
struct BilinearMesh {
  desc::Mesh mesh;
  /// Triangles of every patch: 2 if all are flat, else those of a fine grid.
  std::size_t triangles_per_patch = 2;
};
/// Raises SceneError if the patches make no sense.
BilinearMesh read_bilinear_mesh(const SourceLocation& where, const ParameterList& parameters);

}  // namespace ajar::pbrt
