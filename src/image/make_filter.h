#pragma once
#include "core/error.h"
#include "image/filter.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// The filter that a scene description asks for. The only place where `image/` looks at the plain
/// data of `scene/desc`. Raises SceneError at `where` if its parameters make no filter.
Filter make_filter(const desc::Filter& description, const SourceLocation& where = {});

}  // namespace ajar
