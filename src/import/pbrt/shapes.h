#pragma once
#include <optional>
#include <string>

#include "import/mesh/mesh_loader.h"
#include "import/pbrt/parameter_list.h"
#include "import/pbrt/textures.h"

namespace ajar::pbrt {

/// Geometry of `Shape "type" parameters`. Empty, after a warning, for shapes that cannot be drawn
/// but do not make the scene useless. Raises SceneError for unknown types and meshes that make no
/// sense.
std::optional<desc::Node> make_shape(Context& context, MeshLoader& meshes, TextureTable& textures,
                                     const SourceLocation& where, const std::string& type,
                                     const ParameterList& parameters);

/// `Shape "curve"`: any pbrt-v3 curve as cubic Bézier segments.
std::optional<desc::Node> make_curve(Context& context, const SourceLocation& where,
                                     const ParameterList& parameters);

}  // namespace ajar::pbrt
