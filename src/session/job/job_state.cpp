#include "session/job/job_state.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "session/heuristics.h"

namespace ajar {

double PartialPass::fraction() const {
  const double items = std::accumulate(done.begin(), done.end(), 0.0);
  const double part = done.empty() ? 0.0 : items / static_cast<double>(done.size());
  return (round + part) / rounds;
}

std::uint64_t JobState::mean_samples() const {
  if (!partial || partial->done.empty()) return samples_per_pixel;
  const auto more = static_cast<std::uint64_t>(
      std::llround(partial->fraction() * static_cast<double>(partial->samples)));
  // With nothing at all the picture could not be shown.
  return std::max<std::uint64_t>(1, samples_per_pixel + more);
}

void forget_old_errors(std::vector<JobState::ErrorMark>& recent) {
  if (recent.empty()) return;
  const std::uint64_t half = recent.back().samples / 2;
  while (recent.size() > SessionHeuristics::kFewestMarks && recent.front().samples < half) {
    recent.erase(recent.begin());
  }
}

bool target_is_reached(const std::vector<JobState::ErrorMark>& recent, double target) {
  if (recent.size() < SessionHeuristics::kFewestMarks) return false;
  const auto now = static_cast<double>(recent.back().samples);
  return std::all_of(recent.begin(), recent.end(), [&](const JobState::ErrorMark& mark) {
    return mark.error * std::sqrt(static_cast<double>(mark.samples) / now) <= target;
  });
}

}  // namespace ajar
