#pragma once

namespace ajar::cli {

/// The program from its first line to its exit code.
int run_program(int argc, char** argv);

}  // namespace ajar::cli
