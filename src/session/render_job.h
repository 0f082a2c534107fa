#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

#include "image/film.h"
#include "integrator/integrator.h"
#include "session/budget.h"
#include "session/interrupts.h"
#include "session/resources.h"

namespace ajar {

enum class StopReason { Samples, Time, TargetError, Interrupted };
/// "samples", "time", "target error" or "interrupted".
const char* to_string(StopReason reason);

struct RenderJobOptions {
  Budget budget;
  int threads = 0;            ///< 0: as many as the machine offers
  double pass_seconds = 0.5;  ///< how soon a render reacts to a signal
  /// Relative error of the picture in `film` after that many samples per pixel; empty if it cannot
  /// be known.
  std::function<std::optional<double>(const Film& film, std::uint64_t samples)> estimate_error;
  const InterruptCount* interrupts = nullptr;  ///< may be null
};

/// Where a render stands; may be taken at any time from any thread.
struct RenderSnapshot {
  Budget budget;
  std::uint64_t total_samples = 0;  ///< per pixel; 0 if there is no such limit
  double samples_done = 0.0;        ///< per pixel, the begun pass counted in part
  std::uint64_t rays = 0;
  double seconds = 0.0;
  std::optional<double> relative_error;
  std::uint64_t error_samples = 0;  ///< per pixel, when `relative_error` was taken
  bool finishing = false;           ///< interrupted, waiting for the pass to end
};

struct RenderResult {
  Counters counters;
  std::uint64_t samples_per_pixel = 0;  ///< in the film
  double seconds = 0.0;
  double cpu_seconds = 0.0;  ///< of all threads, while rendering
  int threads = 0;
  std::uint64_t passes = 0;
  std::optional<double> relative_error;
  StopReason stopped_by = StopReason::Samples;
  /// False if the last pass was cut short (second signal): parts of the picture then have fewer
  /// samples, and `samples_per_pixel` is the mean.
  bool complete = true;
};

/// Renders: calls the items of an integrator, pass after pass, on all threads, until the budget is
/// used up. The film ends up with the same bits for any number of threads: items are pure
/// functions, the film's sums do not depend on order, and decisions that look at the picture are
/// taken at sample counts fixed in advance.
class RenderJob {
 public:
  /// One sample per pixel is the smallest pass. The clock of the render starts
  /// here.
  RenderJob(Integrator& integrator, Film& film, RenderJobOptions options);
  /// Renders until the budget is used up. To be called once.
  RenderResult run();
  RenderSnapshot snapshot() const;

 private:
  struct PassOutcome;
  PassOutcome run_pass(std::uint64_t first_sample, std::uint64_t samples);
  bool interrupted(int level) const;
  /// Updates the estimate; true if the target error is reached.
  bool reached_target(std::uint64_t samples);

  Integrator& integrator_;
  Film& film_;
  RenderJobOptions options_;
  PassSchedule schedule_;
  int threads_;
  const Stopwatch clock_;

  std::atomic<std::uint64_t> samples_before_pass_{0};
  std::atomic<std::uint64_t> samples_in_pass_{0};
  std::atomic<std::uint64_t> items_in_pass_{1};
  std::atomic<std::uint64_t> items_done_{0};
  std::atomic<std::uint64_t> rays_{0};
  mutable std::mutex error_mutex_;  // guards the two below
  std::optional<double> relative_error_;
  std::uint64_t error_samples_ = 0;
};

}  // namespace ajar
