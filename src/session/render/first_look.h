#pragma once
#include <vector>

#include "session/render/render_state.h"

namespace ajar {

/// Connects with the viewer, if there is to be one. To be called once there is an integrator.
void open_preview(RenderState& state);

/// Shows what a preparation has seen (`Integrator::take_first_look`) to all who look at pictures
/// while they are rendered. It is as it was rendered, since to filter it takes longer than to
/// render it; it has no other layers, and no samples per pixel in its metadata. Files and results
/// have nothing of it.
void show_first_look(RenderState& state, std::vector<float> rgb);

}  // namespace ajar
