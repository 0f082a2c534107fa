#include "session/preparation.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>

#include "core/parallel_for.h"
#include "session/heuristics.h"

namespace ajar {

PreparationEnd Preparation::must_stop() const {
  if (limits_.interrupts != nullptr && limits_.interrupts->load(std::memory_order_relaxed) > 0) {
    return PreparationEnd::Interrupted;
  }
  const bool is_late =
      limits_.seconds && clock_.seconds() > SessionHeuristics::kMostOfTime * *limits_.seconds;
  return is_late ? PreparationEnd::NoTime : PreparationEnd::Done;
}

PreparationEnd Preparation::must_skip() const {
  PreparationEnd reason = must_stop();
  if (limits_.rounds == rounds_) reason = PreparationEnd::NoTime;
  if (reason == PreparationEnd::Done && limits_.seconds && over_ > 0.0) {
    const double expected = clock_.seconds() * all_ / over_;
    if (expected > SessionHeuristics::kMostOfTime * *limits_.seconds)
      reason = PreparationEnd::NoTime;
  }
  if (limits_.ranks == nullptr) return reason;
  return static_cast<PreparationEnd>(limits_.ranks->maximum(static_cast<std::uint64_t>(reason)));
}

bool Preparation::run_round(int round, Counters& whole) {
  tbb::enumerable_thread_specific<Counters> counters;
  parallel_for(items_.load(), [&](std::uint64_t item) {
    if (limits_.ranks == nullptr && must_stop() != PreparationEnd::Done) return;
    integrator_.prepare_item(round, item, counters.local());
    ++items_done_;
  });
  for (const Counters& own : counters) whole += own;
  return items_done_ == items_;
}

Counters Preparation::run() {
  Counters whole;
  for (int round = 0;; ++round) {
    const PreparationRound next = integrator_.begin_preparation(round);
    if (next.items == 0) return whole;
    items_done_ = 0;
    items_ = next.items;
    running_ = next.effort;
    all_ = over_ + next.effort + next.later_effort;
    end_ = must_skip();
    // Neither a signal nor the clock ever takes back what made a round stop.
    if (end_ == PreparationEnd::Done && !run_round(round, whole)) end_ = must_stop();
    if (end_ != PreparationEnd::Done) {
      integrator_.skip_preparation();
      return whole;
    }
    over_ = over_ + next.effort;
    running_ = 0.0;
    ++rounds_;
  }
}

double Preparation::fraction_done() const {
  const double all = all_;
  if (!(all > 0.0)) return 0.0;
  const double of_round = static_cast<double>(items_done_) / static_cast<double>(items_);
  return std::clamp((over_ + running_ * of_round) / all, 0.0, 1.0);
}

Counters prepare(Integrator& integrator) { return Preparation(integrator).run(); }

}  // namespace ajar
