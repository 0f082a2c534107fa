#include "session/job/render_job.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "core/archive.h"
#include "core/error.h"
#include "core/parallel_for.h"
#include "session/heuristics.h"

namespace ajar {

namespace {

/// Counts of one thread in one pass.
struct ThreadTally {
  Counters counters;
  std::uint64_t first_item = std::numeric_limits<std::uint64_t>::max();
  std::string first_discarded;
  double chain_seconds = 0.0;
};

/// Puts at the root what all ranks counted. Of the discarded the root's own is the one described.
void sum_counters(Ranks& ranks, JobState& state) {
  constexpr std::array<double JobState::*, 2> kSeconds = {&JobState::chain_seconds,
                                                          &JobState::cpu_seconds};
  Counters& counters = state.counters;
  std::vector<std::int64_t> numbers;
  for (const EventCount& count : kEventCounts) {
    numbers.push_back(static_cast<std::int64_t>(counters.*count.number));
  }
  std::vector<double> sums = counters.techniques.sums();
  sums.resize(2 * TechniqueShares::kSlots);
  for (const auto seconds : kSeconds) sums.push_back(state.*seconds);
  std::vector<std::int64_t> whole = numbers;
  std::vector<double> whole_sums = sums;
  ranks.sum_to_root(std::span<const std::int64_t>(numbers), whole);
  ranks.sum_to_root(std::span<const double>(sums), whole_sums);
  if (!ranks.is_root()) return;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    counters.*kEventCounts[i].number = static_cast<std::uint64_t>(whole[i]);
  }
  for (std::size_t i = 0; i < kSeconds.size(); ++i) {
    state.*kSeconds[i] = whole_sums[2 * TechniqueShares::kSlots + i];
  }
  counters.techniques = {};
  counters.techniques.add_sums(std::span(whole_sums).first(2 * TechniqueShares::kSlots));
}

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
    case StopReason::NotYet:
      return "not yet";
  }
  return "";
}

RenderJob::RenderJob(Integrator& integrator, Film& film, RenderJobOptions options)
    : integrator_(integrator),
      film_(film),
      options_(std::move(options)),
      schedule_(options_.budget, film.replicates(), options_.pass_seconds),
      threads_(options_.threads > 0 ? options_.threads : tbb::info::default_concurrency()),
      cpu_before_(cpu_seconds()) {
  if (options_.resumed) {
    state_ = std::move(*options_.resumed);
    if (state_.partial && (state_.partial->done.size() != integrator.items_in_round() ||
                           state_.partial->rounds != integrator.rounds_in_pass())) {
      throw IoError(
          "the checkpoint makes no sense: it is in the middle of a pass of another render");
    }
    seconds_before_ = state_.seconds;
    cpu_seconds_before_ = state_.cpu_seconds;
    relative_error_ = state_.relative_error;
    error_samples_ = state_.error_samples;
    samples_before_pass_ = state_.samples_per_pixel;
    // The end of another budget is no place to take decisions at.
    std::erase_if(state_.recent_errors, [&](const JobState::ErrorMark& mark) {
      return !schedule_.is_natural_milestone(mark.samples);
    });
    // The root alone has what was counted before.
    if (is_root()) {
      rays_ = state_.counters.rays;
    } else {
      state_.counters = {};
      state_.chain_seconds = 0.0;
      cpu_seconds_before_ = 0.0;
    }
  }
  if (options_.ranks != nullptr && (is_root() || integrator.keeps_state())) {
    whole_film_.emplace(film.resolution(), film.crop(), film.filter(), film.replicates(),
                        std::vector<LayerSpec>(film.layers().begin(), film.layers().end()));
  }
}

bool RenderJob::interrupted(int level) const {
  return options_.interrupts != nullptr &&
         options_.interrupts->load(std::memory_order_relaxed) >= level;
}

RenderJob::Decision RenderJob::decide() {
  Decision next;
  const auto stop = [&](StopReason reason) {
    next.stops = true;
    next.shows_picture = false;  // shown at the end
    next.reason = reason;
    return next;
  };
  const std::uint64_t done = state_.samples_per_pixel;
  next.first_sample = done;
  for (PassObserver* observer : options_.observers) {
    next.shows_picture = observer->wants_picture(state_) || next.shows_picture;
  }
  next.shows_picture = next.shows_picture && state_.passes > 0;
  if (interrupt_level_ >= 1 && (done > 0 || state_.partial)) return stop(StopReason::Interrupted);
  if (state_.partial) {
    next.resumes_pass = true;
    next.first_sample = state_.partial->first_sample;
    next.samples = state_.partial->samples;
    return next;
  }
  const auto replicates = static_cast<std::uint64_t>(film_.replicates());
  const auto& recent = state_.recent_errors;
  if (options_.budget.target_error && !recent.empty() && recent.back().samples == done &&
      done >= SessionHeuristics::kSamplesBeforeTarget * replicates &&
      target_is_reached(recent, *options_.budget.target_error)) {
    return stop(StopReason::TargetError);
  }
  next.samples = schedule_.next_pass({done, total_seconds(), state_.seconds_per_sample});
  if (next.samples == 0) {
    return stop(done >= schedule_.total() ? StopReason::Samples : StopReason::Time);
  }
  // An earlier run's speed says little: it may have been on another machine.
  if (!speed_is_known_) next.samples = 1;
  return next;
}

RenderJob::Decision RenderJob::agree() {
  const int own = options_.interrupts != nullptr ? options_.interrupts->load() : 0;
  if (options_.ranks == nullptr) {
    interrupt_level_ = own;
    return decide();
  }
  interrupt_level_ = static_cast<int>(options_.ranks->maximum(static_cast<std::uint64_t>(own)));
  Decision next;
  if (is_root()) next = decide();
  options_.ranks->broadcast(0, std::as_writable_bytes(std::span(&next, 1)));
  return next;
}

WorkSlice RenderJob::own_share() const {
  WorkSlice share = options_.share;
  if (options_.ranks != nullptr) {
    share.index += share.count * static_cast<std::uint64_t>(options_.ranks->rank());
    share.count *= static_cast<std::uint64_t>(options_.ranks->count());
  }
  return share;
}

Film& RenderJob::film_before(const Decision& decision) {
  const bool alone = options_.ranks == nullptr || !integrator_.keeps_state();
  if (alone || !schedule_.is_natural_milestone(decision.first_sample)) return film_;
  gather();
  options_.ranks->broadcast(0, std::as_writable_bytes(whole_film_->raw()));
  return *whole_film_;
}

void RenderJob::share_news() {
  if (options_.ranks == nullptr || !integrator_.keeps_state() || !has_changed_) return;
  has_changed_ = false;
  const WorkSlice own = own_share();
  const std::string given =
      archived([&](OutputArchive& archive) { integrator_.export_delta(archive, own); });
  for (int rank = 0; rank < options_.ranks->count(); ++rank) {
    std::uint64_t size = given.size();
    options_.ranks->broadcast(rank, std::as_writable_bytes(std::span(&size, 1)));
    std::string news = rank == options_.ranks->rank() ? given : std::string(size, '\0');
    options_.ranks->broadcast(rank, std::as_writable_bytes(std::span(news)));
    unarchive(news, [&](InputArchive& archive) {
      integrator_.import_delta(archive, {static_cast<std::uint64_t>(rank), own.count});
    });
  }
}

void RenderJob::run_pass(const Decision& decision, Film& before) {
  // A pass that was cut short has begun already, before the checkpoint.
  if (!decision.resumes_pass) {
    integrator_.begin_pass(decision.first_sample, decision.samples, before);
    // Additions to the film are counted once, at the root.
    if (decision.first_sample == 0 && !is_root()) film_.clear();
  }
  if (!decision.resumes_pass) {
    state_.partial = PartialPass{.first_sample = decision.first_sample,
                                 .samples = decision.samples,
                                 .done = std::vector<std::uint8_t>(integrator_.items_in_round()),
                                 .rounds = integrator_.rounds_in_pass()};
  }
  PartialPass& pass = *state_.partial;
  rounds_ = pass.rounds;
  while (run_round(pass)) {
    if (pass.round + 1 == pass.rounds) {
      state_.partial.reset();
      return;
    }
    share_news();
    integrator_.begin_round(++pass.round);
    pass.done.assign(integrator_.items_in_round(), 0);
  }
}

bool RenderJob::run_round(PartialPass& pass) {
  const WorkSlice share = own_share();
  const std::uint64_t own_items = share.size(pass.done.size());
  items_done_ = 0;
  items_in_round_ = std::max<std::uint64_t>(1, own_items);
  round_ = pass.round;
  samples_in_pass_ = pass.samples;

  tbb::enumerable_thread_specific<ThreadTally> tallies;
  const auto run_items = [&](const tbb::blocked_range<std::uint64_t>& range) {
    ThreadTally& tally = tallies.local();
    for (std::uint64_t i = range.begin(); i != range.end(); ++i) {
      const std::uint64_t item = share.index + i * share.count;
      if (pass.done[item] == 0) {
        // Ranks cannot leave a pass each at another item: they finish it.
        if (options_.ranks == nullptr && interrupted(2)) return;
        Counters counters;
        const double begun = thread_cpu_seconds();
        integrator_.run_item(item, pass.first_sample, pass.samples, film_, counters);
        if (integrator_.is_of_chains(item)) tally.chain_seconds += thread_cpu_seconds() - begun;
        rays_.fetch_add(counters.rays, std::memory_order_relaxed);
        // The message of the smallest item is kept, whatever the threads.
        if (!counters.first_discarded.empty() && item < tally.first_item) {
          tally.first_item = item;
          tally.first_discarded = std::exchange(counters.first_discarded, {});
        }
        counters.first_discarded.clear();
        tally.counters += counters;
        pass.done[item] = 1;
      }
      items_done_.fetch_add(1, std::memory_order_relaxed);
    }
  };
  parallel_for_ranges(own_items, std::uint64_t{1}, run_items, tbb::simple_partitioner());

  Counters counters;
  std::uint64_t first_item = std::numeric_limits<std::uint64_t>::max();
  for (const ThreadTally& tally : tallies) {
    counters += tally.counters;
    state_.chain_seconds += tally.chain_seconds;
    if (tally.first_item < first_item) {
      first_item = tally.first_item;
      counters.first_discarded = tally.first_discarded;
    }
  }
  state_.counters += counters;
  has_changed_ = true;
  return items_done_ == own_items;
}

void RenderJob::end_pass(const Decision& decision, double seconds) {
  ++state_.passes;
  state_.samples_per_pixel = decision.first_sample + decision.samples;
  if (!decision.resumes_pass) {
    state_.seconds_per_sample = seconds / static_cast<double>(decision.samples);
    speed_is_known_ = true;
  }
  samples_in_pass_ = 0;
  samples_before_pass_ = state_.samples_per_pixel;
  // There the integrator may look at what all have done.
  if (schedule_.is_natural_milestone(state_.samples_per_pixel)) share_news();
  if (schedule_.is_milestone(state_.samples_per_pixel)) {
    estimate(state_.samples_per_pixel, schedule_.is_natural_milestone(state_.samples_per_pixel));
  }
}

void RenderJob::estimate(std::uint64_t samples, bool milestone) {
  if (!options_.estimate_error || film_.replicates() < 2) return;
  gather();
  state_.error_samples = samples;
  if (!is_root()) {
    error_samples_ = samples;
    return;
  }
  const std::optional<RelativeError> error = options_.estimate_error(film(), samples);
  state_.relative_error = error;
  std::optional<double> reached;
  if (milestone) {
    reached = error_for_target(error, samples);
    if (reached) {
      state_.recent_errors.push_back({samples, *reached});
      forget_old_errors(state_.recent_errors);
    } else {
      state_.recent_errors.clear();
    }
  }
  const std::lock_guard lock(error_mutex_);
  relative_error_ = error;
  error_samples_ = samples;
  if (milestone && options_.budget.denoised_target) denoised_error_ = reached;
}

std::optional<double> RenderJob::error_for_target(const std::optional<RelativeError>& error,
                                                  std::uint64_t samples) const {
  // Lower bounds do not reach a target.
  if (!error || error->is_lower_bound()) return std::nullopt;
  if (!options_.budget.denoised_target) return error->value;
  return options_.estimate_denoised_error(film(), samples);
}

void RenderJob::gather() {
  if (options_.ranks == nullptr) return;
  share_news();
  options_.ranks->sum_to_root(std::as_const(film_).raw(),
                              whole_film_ ? whole_film_->raw() : std::span<std::int64_t>());
}

JobState RenderJob::gathered_state() {
  JobState whole = state_;
  whole.seconds = total_seconds();
  whole.cpu_seconds = cpu_seconds_before_ + cpu_seconds() - cpu_before_;
  if (options_.ranks != nullptr) sum_counters(*options_.ranks, whole);
  return whole;
}

void RenderJob::show_picture() {
  gather();
  whole_state_ = gathered_state();
  if (!is_root()) return;
  for (PassObserver* observer : options_.observers) observer->see_picture(film(), whole_state_);
}

RenderResult result_of(const JobState& state, StopReason reason) {
  RenderResult result;
  result.counters = state.counters;
  result.samples_per_pixel = state.mean_samples();
  result.seconds = state.seconds;
  result.cpu_seconds = state.cpu_seconds;
  result.chain_seconds = state.chain_seconds;
  result.passes = state.passes;
  result.relative_error = state.relative_error;
  result.complete = !state.partial;
  result.stopped_by = reason;
  return result;
}

RenderResult RenderJob::result_of(StopReason reason) {
  const std::uint64_t samples = state_.mean_samples();
  if (!state_.partial && error_samples_ != samples) estimate(samples, false);
  gather();
  whole_state_ = gathered_state();
  samples_in_pass_ = 0;
  samples_before_pass_ = samples;

  RenderResult result = ajar::result_of(whole_state_, reason);
  result.own_seconds = clock_.seconds();
  result.threads = threads_;
  result.complete = !state_.partial;
  return result;
}

RenderResult RenderJob::run() {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads_));
  tbb::task_arena arena(threads_);
  while (true) {
    const Decision next = agree();
    if (next.shows_picture) show_picture();
    if (next.stops) return result_of(next.reason);
    const Stopwatch pass_clock;
    // Ranks talk to each other on this thread only.
    Film& before = film_before(next);
    arena.execute([&] { run_pass(next, before); });
    if (state_.partial) return result_of(StopReason::Interrupted);
    end_pass(next, pass_clock.seconds());
  }
}

RenderSnapshot RenderJob::snapshot() const {
  RenderSnapshot snapshot;
  snapshot.budget = options_.budget;
  if (options_.budget.samples_per_pixel) snapshot.total_samples = schedule_.total();
  const double pass_fraction =
      (round_.load() + std::min(1.0, static_cast<double>(items_done_.load()) /
                                         static_cast<double>(items_in_round_.load()))) /
      rounds_.load();
  snapshot.samples_done =
      static_cast<double>(samples_before_pass_.load()) +
      std::min(1.0, pass_fraction) * static_cast<double>(samples_in_pass_.load());
  snapshot.rays = rays_;
  snapshot.seconds = total_seconds();
  const std::lock_guard lock(error_mutex_);
  snapshot.relative_error = relative_error_;
  snapshot.error_samples = error_samples_;
  snapshot.denoised_error = denoised_error_;
  snapshot.finishing = interrupted(1);
  return snapshot;
}

}  // namespace ajar
