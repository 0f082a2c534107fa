#pragma once
#include "session/render/render_outcome.h"
#include "session/render/render_state.h"

/// The last steps of a render: its passes, and what becomes of the picture.
namespace ajar {

/// Renders with the prepared method until the end, and writes what is to be written.
RenderOutcome render_passes(RenderState& state);

/// While passes go on, between two: what is known, and the picture.
RenderStatistics statistics_at(const RenderState& state, const JobState& job);
Picture picture_of(const RenderState& state, const Film& film, const JobState& job);

}  // namespace ajar
