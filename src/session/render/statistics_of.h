#pragma once
#include "session/checkpoint/checkpoint.h"
#include "session/output/stats_json.h"

namespace ajar {

/// What a record says of a render; the rest is as by default.
RenderStatistics statistics_of(const RenderRecord& record);

/// What the state of a render says of it.
RenderResult result_of(const JobState& state, StopReason reason);

}  // namespace ajar
