#include "apps/shared/shared_command_line.h"

#include "apps/cli/program.h"

int ajar_command_line(int argc, char** argv) { return ajar::cli::run_program(argc, argv); }
