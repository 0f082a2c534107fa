#pragma once

/// The command line, as the shared library has it for its program: `main`, in short. For nobody
/// else: it handles signals and prints.
extern "C" __attribute__((visibility("default"))) int ajar_command_line(int argc, char** argv);
