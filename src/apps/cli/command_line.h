#pragma once
#include "session/job/ranks.h"

namespace ajar::cli {

/// Parses the command line and runs the command. Returns the exit code; raises `Error`. `ranks`:
/// the processes that render together, of which this is one; null if it is alone.
int run(int argc, const char* const* argv, Ranks* ranks = nullptr);

}  // namespace ajar::cli
