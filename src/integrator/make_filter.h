#pragma once
#include "core/error.h"
#include "image/filter.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// The filter that a scene description asks for. Here, since `image/` knows nothing of scenes.
/// Raises SceneError at the filter's place if its parameters make none.
Filter make_filter(const desc::Filter& description);

}  // namespace ajar
