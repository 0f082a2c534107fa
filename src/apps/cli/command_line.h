#pragma once

namespace ajar::cli {

/// Parses the command line and runs the command. Returns the exit code; raises `Error`.
int run(int argc, const char* const* argv);

}  // namespace ajar::cli
