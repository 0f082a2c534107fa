#include "session/render_job.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel_for.h"

namespace ajar {

namespace {

/// Fewer samples per replicate than this say too little about the error to stop a render.
constexpr std::uint64_t kSamplesPerReplicateBeforeTarget = 4;

/// What one thread counted in one pass.
struct ThreadTally {
  Counters counters;
  std::uint64_t items = 0;
  std::uint64_t first_item = std::numeric_limits<std::uint64_t>::max();
  std::string first_discarded;
};

}  // namespace

const char* to_string(StopReason reason) {
  switch (reason) {
    case StopReason::Samples:
      return "samples";
    case StopReason::Time:
      return "time";
    case StopReason::TargetError:
      return "target error";
    case StopReason::Interrupted:
      return "interrupted";
  }
  return "";
}

struct RenderJob::PassOutcome {
  Counters counters;
  std::uint64_t items = 0;  ///< that were run
};

RenderJob::RenderJob(Integrator& integrator, Film& film, RenderJobOptions options)
    : integrator_(integrator),
      film_(film),
      options_(std::move(options)),
      schedule_(options_.budget, film.replicates(), options_.pass_seconds),
      threads_(options_.threads > 0 ? options_.threads : tbb::info::default_concurrency()) {}

bool RenderJob::interrupted(int level) const {
  return options_.interrupts != nullptr &&
         options_.interrupts->load(std::memory_order_relaxed) >= level;
}

RenderJob::PassOutcome RenderJob::run_pass(std::uint64_t first_sample, std::uint64_t samples) {
  integrator_.begin_pass(first_sample, samples, film_);
  const std::uint64_t items = integrator_.items_in_pass();
  items_done_ = 0;
  items_in_pass_ = std::max<std::uint64_t>(1, items);
  samples_in_pass_ = samples;

  tbb::enumerable_thread_specific<ThreadTally> tallies;
  const auto run_items = [&](const tbb::blocked_range<std::uint64_t>& range) {
    ThreadTally& tally = tallies.local();
    for (std::uint64_t item = range.begin(); item != range.end(); ++item) {
      if (interrupted(2)) return;
      Counters counters;
      integrator_.run_item(item, first_sample, samples, film_, counters);
      rays_.fetch_add(counters.rays, std::memory_order_relaxed);
      items_done_.fetch_add(1, std::memory_order_relaxed);
      // Which message is kept must not depend on the threads: the one of the smallest item.
      if (!counters.first_discarded.empty() && item < tally.first_item) {
        tally.first_item = item;
        tally.first_discarded = std::exchange(counters.first_discarded, {});
      }
      counters.first_discarded.clear();
      tally.counters += counters;
      ++tally.items;
    }
  };
  parallel_for_ranges(items, std::uint64_t{1}, run_items, tbb::simple_partitioner());
  integrator_.end_pass();

  PassOutcome outcome;
  std::uint64_t first_item = std::numeric_limits<std::uint64_t>::max();
  for (const ThreadTally& tally : tallies) {
    outcome.counters += tally.counters;
    outcome.items += tally.items;
    if (tally.first_item < first_item) {
      first_item = tally.first_item;
      outcome.counters.first_discarded = tally.first_discarded;
    }
  }
  return outcome;
}

bool RenderJob::reached_target(std::uint64_t samples) {
  if (!options_.estimate_error || film_.replicates() < 2) return false;
  const std::optional<double> error = options_.estimate_error(film_, samples);
  const std::lock_guard lock(error_mutex_);
  relative_error_ = error;
  error_samples_ = samples;
  const auto replicates = static_cast<std::uint64_t>(film_.replicates());
  return error && options_.budget.target_error && *error <= *options_.budget.target_error &&
         samples >= kSamplesPerReplicateBeforeTarget * replicates;
}

RenderResult RenderJob::run() {
  const double cpu_before = cpu_seconds();
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads_));
  tbb::task_arena arena(threads_);

  RenderResult result;
  result.threads = threads_;
  PassHistory history;
  while (true) {
    if (interrupted(1) && history.samples_done > 0) {
      result.stopped_by = StopReason::Interrupted;
      break;
    }
    const std::uint64_t samples = schedule_.next_pass(history);
    if (samples == 0) {
      result.stopped_by =
          history.samples_done >= schedule_.total() ? StopReason::Samples : StopReason::Time;
      break;
    }
    const Stopwatch pass_clock;
    const PassOutcome outcome =
        arena.execute([&] { return run_pass(history.samples_done, samples); });
    result.counters += outcome.counters;
    ++result.passes;
    const std::uint64_t items = integrator_.items_in_pass();
    if (outcome.items < items) {
      // Keeps the brightness of the picture right on average.
      const double done = static_cast<double>(outcome.items) / static_cast<double>(items);
      const auto partly =
          static_cast<std::uint64_t>(std::llround(done * static_cast<double>(samples)));
      history.samples_done += history.samples_done == 0 ? samples : partly;
      result.complete = false;
      result.stopped_by = StopReason::Interrupted;
      break;
    }
    history.samples_done += samples;
    history.seconds_per_sample = pass_clock.seconds() / static_cast<double>(samples);
    samples_in_pass_ = 0;
    samples_before_pass_ = history.samples_done;
    if (schedule_.is_milestone(history.samples_done) && reached_target(history.samples_done)) {
      result.stopped_by = StopReason::TargetError;
      break;
    }
    history.seconds = clock_.seconds();
  }

  result.samples_per_pixel = history.samples_done;
  samples_in_pass_ = 0;
  samples_before_pass_ = history.samples_done;
  result.seconds = clock_.seconds();
  result.cpu_seconds = cpu_seconds() - cpu_before;
  if (result.complete && error_samples_ != history.samples_done) {
    reached_target(history.samples_done);
  }
  result.relative_error = relative_error_;
  return result;
}

RenderSnapshot RenderJob::snapshot() const {
  RenderSnapshot snapshot;
  snapshot.budget = options_.budget;
  if (options_.budget.samples_per_pixel) snapshot.total_samples = schedule_.total();
  const double pass_fraction =
      static_cast<double>(items_done_.load()) / static_cast<double>(items_in_pass_.load());
  snapshot.samples_done =
      static_cast<double>(samples_before_pass_.load()) +
      std::min(1.0, pass_fraction) * static_cast<double>(samples_in_pass_.load());
  snapshot.rays = rays_;
  snapshot.seconds = clock_.seconds();
  const std::lock_guard lock(error_mutex_);
  snapshot.relative_error = relative_error_;
  snapshot.error_samples = error_samples_;
  snapshot.finishing = interrupted(1);
  return snapshot;
}

}  // namespace ajar
