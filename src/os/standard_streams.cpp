#include "os/standard_streams.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <string>
#include <system_error>

#include "core/error.h"

namespace ajar {

namespace {

constexpr int kForever = -1;

/// Waits until the descriptor takes something; false if it does not within so many milliseconds.
bool wait_for_room(int descriptor, int milliseconds) {
  pollfd waiting{descriptor, POLLOUT, 0};
  int ready = 0;
  do {
    ready = ::poll(&waiting, 1, milliseconds);
  } while (ready < 0 && errno == EINTR);
  return ready != 0;
}

/// 0 or an errno. Pipes are given no more at once than they take without blocking once there is
/// room; terminals that are stopped (Ctrl-S) have none.
int write_all(int descriptor, std::string_view text, int milliseconds) {
  while (!text.empty()) {
    if (!wait_for_room(descriptor, milliseconds)) return EAGAIN;
    const ssize_t written =
        ::write(descriptor, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
    if (written < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// `nobody_reads`: whether that was so the last time.
void write_if_read(int descriptor, std::string_view text, std::atomic<bool>& nobody_reads) {
  constexpr int kPatience = 1000;
  nobody_reads = write_all(descriptor, text, nobody_reads ? 0 : kPatience) == EAGAIN;
}

}  // namespace

void say(std::string_view text) {
  static std::atomic<bool> nobody_reads{false};
  write_if_read(STDERR_FILENO, text, nobody_reads);
}

void say_on_stdout(std::string_view text) {
  static std::atomic<bool> nobody_reads{false};
  write_if_read(STDOUT_FILENO, text, nobody_reads);
}

void print_result(std::string_view text) {
  const int reason = write_all(STDOUT_FILENO, text, kForever);
  if (reason == 0 || reason == EPIPE) return;
  throw IoError("cannot write to the standard output: " + std::system_category().message(reason));
}

void reserve_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    // The lowest that is free, which is this one. For reading: writing still fails, as it should.
    [[maybe_unused]] const int opened = ::open("/dev/null", O_RDONLY);
  }
}

}  // namespace ajar
