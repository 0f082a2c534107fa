#include "apps/cli/progress_reporter.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/error.h"
#include "os/standard_streams.h"
#include "session/job/progress.h"

using namespace std::chrono_literals;

namespace ajar::cli {

namespace {

int terminal_columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

std::chrono::milliseconds interval(ProgressStyle style) {
  switch (style) {
    case ProgressStyle::Bar:
      return 150ms;
    case ProgressStyle::Plain:
      return 5s;
    default:
      return 1s;
  }
}

}  // namespace

ProgressStyle progress_style(const std::string& name, bool is_terminal) {
  if (name == "auto") return is_terminal ? ProgressStyle::Bar : ProgressStyle::Plain;
  if (name == "plain") return ProgressStyle::Plain;
  if (name == "json") return ProgressStyle::Json;
  if (name == "none") return ProgressStyle::None;
  const std::vector<std::string> valid{"auto", "plain", "json", "none"};
  throw UsageError(unknown_name_message("kind of progress", name, valid));
}

ProgressReporter::ProgressReporter(ProgressStyle style, std::function<RenderSnapshot()> snapshot)
    : style_(style), snapshot_(std::move(snapshot)) {
  if (style_ != ProgressStyle::None) {
    thread_ = std::thread([this] { report_until_stopped(); });
  }
}

ProgressReporter::~ProgressReporter() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
  show(true);
}

void ProgressReporter::report_until_stopped() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, interval(style_), [this] { return stop_; })) show(false);
}

void ProgressReporter::show(bool last) const {
  const RenderSnapshot snapshot = snapshot_();
  if (last && !snapshot.renders()) {
    if (style_ == ProgressStyle::Bar) say("\r\x1b[K");
    return;
  }
  switch (style_) {
    case ProgressStyle::Bar:
      // Carriage return, text, "erase to the end of the line".
      say("\r" + bar_line(snapshot, terminal_columns()) + "\x1b[K" + (last ? "\n" : ""));
      break;
    case ProgressStyle::Plain:
      say("ajar: " + plain_line(snapshot) + "\n");
      break;
    case ProgressStyle::Json:
      say(json_line(snapshot, last ? "done" : "progress") + "\n");
      break;
    case ProgressStyle::None:
      break;
  }
}

void report_phase(ProgressStyle style, const std::string& phase) {
  if (style != ProgressStyle::Json) return;
  say(nlohmann::ordered_json{{"event", "phase"}, {"phase", phase}}.dump() + "\n");
}

}  // namespace ajar::cli
