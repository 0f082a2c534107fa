#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "session/render_job.h"

namespace ajar {

enum class ProgressStyle {
  Bar,    ///< one line that is drawn over
  Plain,  ///< a line now and then, for logs
  Json,   ///< one JSON object per line, for programs
  None
};

/// From the name of `--progress`: auto (a bar if `is_terminal`, else plain), plain, json, none.
/// Raises UsageError.
ProgressStyle progress_style(const std::string& name, bool is_terminal);

/// Seconds until the first limit of the budget is reached, as far as can be told; an error falls
/// with the square root of the samples.
std::optional<double> seconds_left(const RenderSnapshot& snapshot);
/// Part of the render that is done, 0…1; empty without a limit.
std::optional<double> fraction_done(const RenderSnapshot& snapshot);

/// `0:05`, `12:03`, `1:02:03`.
std::string clock_text(double seconds);
/// Number with a unit prefix: `950`, `12.3 k`, `4.56 M`.
std::string short_number(double value);

/// `12 %`, or `≥ 12 %` of what is a lower bound.
std::string error_text(const RelativeError& error);

/// One line without line break, at most `columns` wide.
std::string bar_line(const RenderSnapshot& snapshot, int columns);
std::string plain_line(const RenderSnapshot& snapshot);
/// Keys: event ("progress" or "done"), phase ("prepare" or "render"), seconds, samples_per_pixel,
/// total_samples_per_pixel, rays, rays_per_second, estimated_relative_error, fraction,
/// seconds_left, finishing; null where unknown.
std::string json_line(const RenderSnapshot& snapshot, const std::string& event);

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

}  // namespace ajar
