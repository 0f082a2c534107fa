#pragma once
#include <vector>

#include "core/warnings.h"
#include "session/job/render_job.h"

namespace ajar {

/// Warnings of a render on its picture: light that was dropped, samples that some pixels lack.
std::vector<Warning> concerns_about(const RenderResult& result);

}  // namespace ajar
