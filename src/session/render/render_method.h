#pragma once
#include "session/render/render_state.h"

/// The steps of a render between its scene and its passes.
namespace ajar {

/// Makes the planned integrator, prepares it and makes its film, or takes both from where the
/// render goes on. False if the user stopped it and there is nothing to render. Raises UsageError
/// for what this method cannot do, and for a checkpoint that does not fit, IoError for one that
/// makes no sense.
bool prepare_method(RenderState& state);

}  // namespace ajar
