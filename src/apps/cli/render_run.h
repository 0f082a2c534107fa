#pragma once
#include <string>

#include "apps/cli/commands.h"
#include "session/render/render_order.h"

namespace ajar::cli {

/// What `render` and `resume` are told in the same way. Raises UsageError.
RenderOrder order_of(const RunArguments& arguments);

/// Renders, and tells the user; `progress`: see `progress_style`. Returns the exit code or raises
/// an `Error`.
int carry_out(RenderOrder order, const std::string& progress);

}  // namespace ajar::cli
