#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "image/film.h"
#include "image/relative_error.h"
#include "integrator/integrator.h"
#include "session/job/budget.h"
#include "session/job/interrupts.h"
#include "session/job/job_state.h"
#include "session/job/pass_observer.h"
#include "session/job/ranks.h"
#include "session/job/render_phase.h"
#include "session/job/resources.h"

namespace ajar {

/// `NotYet`: the render goes on.
enum class StopReason { Samples, Time, TargetError, Interrupted, NotYet };
/// "samples", "time", "target error", "interrupted" or "not yet".
const char* to_string(StopReason reason);

struct RenderJobOptions {
  Budget budget;
  int threads = 0;            ///< 0: as many as the machine offers
  double pass_seconds = 0.5;  ///< target length of a pass: the latency of signals
  /// Relative error of the picture in `film` after that many samples per pixel; empty if it cannot
  /// be known.
  std::function<std::optional<RelativeError>(const Film& film, std::uint64_t samples)>
      estimate_error;
  /// Error of the denoised picture; called where the budget's target is that error.
  std::function<std::optional<double>(const Film& film, std::uint64_t samples)>
      estimate_denoised_error;
  const InterruptCount* interrupts = nullptr;  ///< may be null
  /// Where to go on; the film has the sums, the integrator its state.
  std::optional<JobState> resumed;
  WorkSlice share;         ///< share of this job, all its ranks together
  Ranks* ranks = nullptr;  ///< cooperating processes; null: this process alone
  std::vector<PassObserver*> observers;
};

/// Where a render stands; may be taken at any time from any thread.
struct RenderSnapshot {
  Budget budget;
  std::uint64_t total_samples = 0;  ///< per pixel; 0 if there is no such limit
  double samples_done = 0.0;        ///< per pixel, the begun pass counted in part
  std::uint64_t rays = 0;
  double seconds = 0.0;
  std::optional<RelativeError> relative_error;
  std::uint64_t error_samples = 0;       ///< per pixel, when `relative_error` was taken
  std::optional<double> denoised_error;  ///< then, where it is the target
  bool finishing = false;                ///< interrupted, waiting for the pass to end
  /// `Prepare` and `Denoise`: what comes before the passes, or after them; then the other numbers
  /// but `seconds` mean nothing.
  RenderPhase phase = RenderPhase::Render;
  double phase_done = 0.0;  ///< finished part of such a step, 0…1
  bool renders() const { return phase == RenderPhase::Render; }
};

struct RenderResult {
  Counters counters;
  std::uint64_t samples_per_pixel = 0;  ///< in the film
  double seconds = 0.0;                 ///< seconds of all runs, if the render was resumed
  double own_seconds = 0.0;             ///< seconds of this run
  double cpu_seconds = 0.0;             ///< CPU time of all threads, while rendering
  double chain_seconds = 0.0;           ///< CPU time of items of Markov chains
  int threads = 0;
  std::uint64_t passes = 0;
  std::optional<RelativeError> relative_error;
  StopReason stopped_by = StopReason::Samples;
  /// False if the last pass was cut short (second signal): parts of the picture then have fewer
  /// samples, and `samples_per_pixel` is the mean.
  bool complete = true;
};

/// Result of a render in that state.
RenderResult result_of(const JobState& state, StopReason reason);

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
  /// After the run, at the root: the whole picture, and where the render stands.
  const Film& film() const { return whole_film_ ? *whole_film_ : film_; }
  const JobState& state() const { return whole_state_; }

 private:
  /// Next step of all ranks.
  struct Decision {
    std::uint64_t samples = 0;  ///< per pixel of the next pass
    std::uint64_t first_sample = 0;
    bool resumes_pass = false;  ///< the pass that was cut short
    bool stops = false;
    StopReason reason = StopReason::Samples;
    bool shows_picture = false;  ///< the picture is wanted before
  };
  Decision decide();
  /// Decides what comes next, the same on all ranks.
  Decision agree();
  /// `before`: see `film_before`.
  void run_pass(const Decision& decision, Film& before);
  /// Runs what has not run of the round's items. Returns whether all have.
  bool run_round(PartialPass& pass);
  /// Items of this rank.
  WorkSlice own_share() const;
  /// Film so far, for the integrator before a pass.
  Film& film_before(const Decision& decision);
  /// After a pass: lets all ranks know what the items of each have left behind.
  void share_news();
  /// After a pass that was not cut short.
  void end_pass(const Decision& decision, double seconds);
  void estimate(std::uint64_t samples, bool milestone);
  /// The error that the target is about, at a milestone with that estimate of the picture; empty if
  /// it cannot be trusted.
  std::optional<double> error_for_target(const std::optional<RelativeError>& error,
                                         std::uint64_t samples) const;
  bool interrupted(int level) const;
  bool is_root() const { return options_.ranks == nullptr || options_.ranks->is_root(); }
  /// Brings what the ranks have together at the root.
  void gather();
  JobState gathered_state();
  void show_picture();
  RenderResult result_of(StopReason reason);
  double total_seconds() const { return seconds_before_ + clock_.seconds(); }

  Integrator& integrator_;
  Film& film_;
  RenderJobOptions options_;
  PassSchedule schedule_;
  int threads_;
  const Stopwatch clock_;
  const double cpu_before_;
  double seconds_before_ = 0.0;      ///< seconds of earlier runs
  double cpu_seconds_before_ = 0.0;  ///< CPU time of earlier runs
  JobState state_;                   ///< state of this rank
  JobState whole_state_;             ///< state of all ranks, at the root; when last gathered
  /// Film of all ranks; empty without other ranks. If the integrator keeps state, all ranks have
  /// one.
  std::optional<Film> whole_film_;
  bool has_changed_ = false;     ///< state changed since ranks last synchronised
  bool speed_is_known_ = false;  ///< `state_.seconds_per_sample` is of this run
  int interrupt_level_ = 0;      ///< the highest of all ranks

  std::atomic<std::uint64_t> samples_before_pass_{0};
  std::atomic<std::uint64_t> samples_in_pass_{0};
  std::atomic<std::uint64_t> items_in_round_{1};
  std::atomic<int> round_{0};
  std::atomic<int> rounds_{1};
  std::atomic<std::uint64_t> items_done_{0};
  std::atomic<std::uint64_t> rays_{0};
  mutable std::mutex error_mutex_;  // guards those below
  std::optional<RelativeError> relative_error_;
  std::uint64_t error_samples_ = 0;
  std::optional<double> denoised_error_;
};

}  // namespace ajar
