#pragma once
#include <string>
#include <vector>

#include "session/job/interrupts.h"

namespace ajar::study {

/// Exit of a program.
struct ChildResult {
  int exit_code = -1;        ///< negative: ended by that signal
  bool interrupted = false;  ///< a signal came before its end
};

struct ChildCommand {
  std::string program;
  std::vector<std::string> arguments;
  std::string folder;  ///< where it runs
  std::string log;     ///< takes its stdout and stderr
};

/// Runs a program to its end. Every further signal that `interrupts` counts meanwhile is passed on
/// as SIGINT; the child has a process group of its own, so that Ctrl-C reaches it once and not
/// twice. It ends with this program, however that ends. Raises IoError if it cannot be started.
ChildResult run_child(const ChildCommand& command, const InterruptCount& interrupts);

/// This program, to be started again: the very same build, even if its file is replaced meanwhile.
inline constexpr const char* kOwnProgram = "/proc/self/exe";

}  // namespace ajar::study
