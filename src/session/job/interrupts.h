#pragma once
#include <atomic>

namespace ajar {

/// Number of requests to stop (Ctrl-C, SIGTERM): 0 go on; 1 finish the pass; 2 skip items that have
/// not begun.
using InterruptCount = std::atomic<int>;

/// Routes signals to counters. SIGINT and SIGTERM ask to stop. Before `begin_render` there is
/// nothing to save and they end the program at once with exit code 130; afterwards the first counts
/// 1, the second 2, and the third ends the program at once. SIGHUP (unless ignored, as under nohup)
/// and SIGUSR1 ask for the picture as it is. SIGPIPE and SIGXFSZ are ignored, so that neither a
/// closed terminal nor a limit on the size of files ends a render.
void install_interrupt_handlers();
/// From here on signals are counted.
void begin_render();
/// The counter; zero until a signal arrives during a render.
InterruptCount& interrupt_count();
/// Number of requests for the picture.
const InterruptCount& picture_requests();

}  // namespace ajar
