#pragma once
#include "core/located_json.h"

namespace ajar::tungsten {

/// Raises SceneError for files of other programs. JSON is used for much else, too: studies,
/// statistics, scenes of renderers that have a "camera" and "primitives" as well. The message names
/// the kind of file, if known.
void require_scene(const LocatedJson& root);

}  // namespace ajar::tungsten
