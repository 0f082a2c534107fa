#pragma once
#include "import/gltf/nodes.h"

namespace ajar::gltf {

/// Sets the scene's camera and the shape of its film from the first node with a camera. False if
/// there is none.
bool set_camera(Context& context, const std::vector<PlacedNode>& nodes);

}  // namespace ajar::gltf
