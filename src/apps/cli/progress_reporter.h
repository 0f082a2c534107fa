#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "session/job/render_job.h"

namespace ajar::cli {

enum class ProgressStyle {
  Bar,    ///< one line that is drawn over
  Plain,  ///< a line now and then, for logs
  Json,   ///< one JSON object per line, for programs
  None
};

/// From the name of `--progress`: auto (a bar if `is_terminal`, else plain), plain, json, none.
/// Raises UsageError.
ProgressStyle progress_style(const std::string& name, bool is_terminal);

/// Shows on stderr where a render stands, from its own thread, until destroyed.
class ProgressReporter {
 public:
  ProgressReporter(ProgressStyle style, std::function<RenderSnapshot()> snapshot);
  ~ProgressReporter();
  ProgressReporter(const ProgressReporter&) = delete;
  ProgressReporter& operator=(const ProgressReporter&) = delete;

 private:
  void report_until_stopped();
  void show(bool last) const;

  ProgressStyle style_;
  std::function<RenderSnapshot()> snapshot_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stop_ = false;
  std::thread thread_;
};

/// Tells programs that read `--progress json` which step has begun:
/// {"event":"phase","phase":"load"}.
void report_phase(ProgressStyle style, const std::string& phase);

}  // namespace ajar::cli
