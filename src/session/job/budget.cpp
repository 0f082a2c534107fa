#include "session/job/budget.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/milestones.h"

namespace ajar {

namespace {

std::uint64_t round_up(std::uint64_t value, std::uint64_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

}  // namespace

double seconds_of_passes(double limit, double before, double kept, double after) {
  const double left = std::max(0.0, limit - (before - kept));
  return std::max(0.0, left - std::min(after, 0.5 * left) - kept);
}

PassSchedule::PassSchedule(const Budget& budget, int replicates, double pass_seconds)
    : budget_(budget),
      replicates_(static_cast<std::uint64_t>(std::max(1, replicates))),
      pass_seconds_(pass_seconds) {
  const std::uint64_t wanted = budget.samples_per_pixel.value_or(kMaxSamples);
  total_ = round_up(std::min(wanted, kMaxSamples), replicates_);
}

bool PassSchedule::is_milestone(std::uint64_t samples) const {
  return samples == total_ || is_natural_milestone(samples);
}

bool PassSchedule::is_natural_milestone(std::uint64_t samples) const {
  return samples > 0 && milestone_after(samples - 1, replicates_) == samples;
}

std::uint64_t PassSchedule::next_pass(const PassHistory& history) const {
  if (history.samples_done >= total_) return 0;
  const std::uint64_t most =
      std::min(milestone_after(history.samples_done, replicates_), total_) - history.samples_done;
  // The shortest pass there is: how long it takes is not known yet.
  if (history.samples_done == 0) return 1;

  double affordable_seconds = pass_seconds_;
  if (budget_.seconds) {
    const double left = *budget_.seconds - history.seconds;
    // Ends nearest to the limit: a pass that would mostly lie beyond it is not begun.
    if (left <= 0.0 || left < 0.5 * history.seconds_per_sample) return 0;
    affordable_seconds = std::min(affordable_seconds, left);
  }
  if (history.seconds_per_sample * static_cast<double>(most) <= affordable_seconds) return most;
  const double affordable = std::floor(affordable_seconds / history.seconds_per_sample);
  return std::clamp<std::uint64_t>(static_cast<std::uint64_t>(affordable), 1, most);
}

}  // namespace ajar
