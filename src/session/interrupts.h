#pragma once
#include <atomic>

namespace ajar {

/// How often the user asked to stop (Ctrl-C, SIGTERM, SIGHUP): 0 go on; 1 finish the pass; 2 skip
/// what has not begun.
using InterruptCount = std::atomic<int>;

/// Routes SIGINT, SIGTERM and SIGHUP (unless ignored, as under nohup) to a counter. Before
/// `begin_render` there is nothing to save and a signal ends the program at once with exit code
/// 130; afterwards the first signal counts 1, the second 2, and the third ends the program at once.
/// SIGPIPE is ignored, so that a closed terminal does not end a render.
void install_interrupt_handlers();
/// From here on signals are counted.
void begin_render();
/// The counter; zero until a signal arrives during a render.
const InterruptCount& interrupt_count();

}  // namespace ajar
