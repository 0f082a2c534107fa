#pragma once
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Whether anything of the scene has a medium beside it: a shape, a light or the camera.
bool uses_media(const desc::SceneDesc& scene);

}  // namespace ajar
