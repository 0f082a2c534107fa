#include "session/job/interrupts.h"

#include <unistd.h>

#include <csignal>

namespace ajar {

namespace {

constexpr int kExitInterrupted = 130;

InterruptCount interrupts{0};
InterruptCount pictures{0};
std::atomic<bool> rendering{false};
static_assert(InterruptCount::is_always_lock_free, "needed in a signal handler");

extern "C" void count_signal(int) {
  if (!rendering.load(std::memory_order_relaxed)) _exit(kExitInterrupted);
  if (interrupts.fetch_add(1, std::memory_order_relaxed) >= 2) _exit(kExitInterrupted);
}

extern "C" void count_picture(int) { pictures.fetch_add(1, std::memory_order_relaxed); }

void handle(int signal, void (*handler)(int)) {
  struct sigaction previous {};
  sigaction(signal, nullptr, &previous);
  if (previous.sa_handler == SIG_IGN && signal == SIGHUP) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void install_interrupt_handlers() {
  for (const int signal : {SIGINT, SIGTERM}) handle(signal, count_signal);
  for (const int signal : {SIGHUP, SIGUSR1}) handle(signal, count_picture);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void begin_render() { rendering = true; }

InterruptCount& interrupt_count() { return interrupts; }
const InterruptCount& picture_requests() { return pictures; }

}  // namespace ajar
