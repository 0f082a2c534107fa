#pragma once
#include "import/common/located_json.h"

namespace ajar::tungsten {

/// Raises SceneError for files of other programs. JSON is much else, too: studies, statistics,
/// scenes of renderers that have a "camera" and "primitives" as well. What such a file is of is in
/// the message, where it can be told.
void require_scene(const LocatedJson& root);

}  // namespace ajar::tungsten
