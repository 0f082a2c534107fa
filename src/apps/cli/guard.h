#pragma once
#include <functional>

namespace ajar::cli {

/// Runs a command and turns what it raises into a message and the exit code of that kind of error.
/// `after_error`, which may be empty, is called with the code when something was raised.
int guard(const std::function<int()>& command, const std::function<void(int)>& after_error = {});

}  // namespace ajar::cli
