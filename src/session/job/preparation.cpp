#include "session/job/preparation.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/parallel_for.h"
#include "session/heuristics.h"

namespace ajar {

double Preparation::limit(bool stays) const {
  if (!limits_.seconds) return std::numeric_limits<double>::infinity();
  return *limits_.seconds *
         (stays ? SessionHeuristics::kMostOfTimeForPicture : SessionHeuristics::kMostOfTime);
}

double Preparation::deadline(bool stays) const {
  return stays ? limit(true) : std::min(limit(true), limit(false) + seconds_kept_);
}

PreparationEnd Preparation::must_stop(double deadline) const {
  if (limits_.interrupts != nullptr && limits_.interrupts->load(std::memory_order_relaxed) > 0) {
    return PreparationEnd::Interrupted;
  }
  return seconds() > deadline ? PreparationEnd::NoTime : PreparationEnd::Done;
}

Preparation::Efforts Preparation::efforts_with(const PreparationRound& next) const {
  double all = over_ + next.effort;
  double stays = stays_ + (next.stays ? next.effort : 0.0);
  if (!next.serves_alone) {
    all += next.later_effort;
    stays += next.later_kept_effort;
  }
  return {all, all - stays};
}

bool Preparation::has_few_samples(const PreparationRound& next) const {
  if (!limits_.samples || next.sample_effort == 0.0) return false;
  const auto [all, lost] = efforts_with(next);
  const double whole = static_cast<double>(*limits_.samples) * next.sample_effort + lost;
  const double few = SessionHeuristics::kFewToPrepare / static_cast<double>(limits_.pixels);
  return lost > std::max(few, SessionHeuristics::kMostOfTime * whole) ||
         all > std::max(few, SessionHeuristics::kMostOfTimeForPicture * whole);
}

PreparationEnd Preparation::must_skip(const PreparationRound& next) const {
  PreparationEnd reason = must_stop(deadline(next.stays));
  if (reason == PreparationEnd::Done && has_few_samples(next)) reason = PreparationEnd::FewSamples;
  if (limits_.earlier && limits_.earlier->rounds == rounds_) {
    const bool of_time = limits_.earlier->of == PreparationCut::Time;
    reason = of_time ? PreparationEnd::NoTime : PreparationEnd::FewSamples;
  }
  if (reason == PreparationEnd::Done && over_ > 0.0) {
    const auto [all, lost] = efforts_with(next);
    const double per_effort = seconds() / over_;
    if (per_effort * lost > limit(false) || per_effort * all > limit(true)) {
      reason = PreparationEnd::NoTime;
    }
  }
  if (limits_.ranks == nullptr) return reason;
  return static_cast<PreparationEnd>(limits_.ranks->maximum(static_cast<std::uint64_t>(reason)));
}

bool Preparation::will_be_late(double deadline) {
  // Items in progress are half done, on average.
  const double done =
      0.5 * static_cast<double>(items_begun_ + items_done_) / static_cast<double>(items_);
  if (done < SessionHeuristics::kTelling || items_done_ == 0 || has_told_.exchange(true)) {
    return false;
  }
  return round_began_ + (seconds() - round_began_) / done > deadline;
}

PreparationEnd Preparation::run_round(int round, double deadline, Counters& whole) {
  round_began_ = seconds();
  tbb::enumerable_thread_specific<Counters> counters;
  std::atomic<PreparationEnd> end = PreparationEnd::Done;
  parallel_for(items_.load(), [&](std::uint64_t item) {
    if (end != PreparationEnd::Done) return;
    if (limits_.ranks == nullptr) {
      const PreparationEnd now =
          will_be_late(deadline) ? PreparationEnd::NoTime : must_stop(deadline);
      if (now != PreparationEnd::Done) {
        end = now;
        return;
      }
    }
    ++items_begun_;
    integrator_.prepare_item(round, item, counters.local());
    ++items_done_;
  });
  for (const Counters& own : counters) whole += own;
  return end;
}

Counters Preparation::run() {
  Counters whole;
  for (int round = 0;; ++round) {
    const PreparationRound next = integrator_.begin_preparation(round);
    std::vector<float> look = integrator_.take_first_look();
    if (show_ && !look.empty()) show_(std::move(look));
    if (next.items == 0) return whole;
    items_begun_ = 0;
    items_done_ = 0;
    has_told_ = false;
    items_ = next.items;
    running_ = next.effort;
    all_ = over_ + next.effort + next.later_effort;
    end_ = must_skip(next);
    if (end_ == PreparationEnd::Done) end_ = run_round(round, deadline(next.stays), whole);
    if (end_ != PreparationEnd::Done) {
      integrator_.skip_preparation(end_ == PreparationEnd::FewSamples ? PreparationCut::Samples
                                                                      : PreparationCut::Time);
      return whole;
    }
    over_ = over_ + next.effort;
    if (next.stays) {
      stays_ += next.effort;
      seconds_kept_ += seconds() - round_began_;
    }
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
