#include "session/interrupts.h"

#include <unistd.h>

#include <csignal>

namespace ajar {

namespace {

constexpr int kExitInterrupted = 130;

InterruptCount count{0};
std::atomic<bool> rendering{false};
static_assert(InterruptCount::is_always_lock_free, "needed in a signal handler");

extern "C" void count_signal(int) {
  if (!rendering.load(std::memory_order_relaxed)) _exit(kExitInterrupted);
  if (count.fetch_add(1, std::memory_order_relaxed) >= 2) _exit(kExitInterrupted);
}

void handle(int signal) {
  struct sigaction previous {};
  sigaction(signal, nullptr, &previous);
  if (previous.sa_handler == SIG_IGN && signal == SIGHUP) return;
  struct sigaction action {};
  action.sa_handler = count_signal;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void install_interrupt_handlers() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal);
  std::signal(SIGPIPE, SIG_IGN);
}

void begin_render() { rendering = true; }

const InterruptCount& interrupt_count() { return count; }

}  // namespace ajar
