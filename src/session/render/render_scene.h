#pragma once
#include "session/render/render_state.h"

/// The first steps of a render: from its order to a scene in memory.
namespace ajar {

/// Loads the scene to be rendered. Raises as `load_scene` does.
desc::SceneDesc load_description(RenderState& state);

/// Builds the scene for what was planned, unless it is built already, and tells what is unusual in
/// it. Raises SceneError, and UsageError for a picture that does not fit into memory.
void build_scene(RenderState& state, desc::SceneDesc description);

}  // namespace ajar
