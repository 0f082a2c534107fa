#include "integrator/selective/lasting_error.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/archive.h"
#include "image/visible_error.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

namespace {

constexpr std::size_t kBetween = SelectiveHeuristics::kStretchesBetween;

/// Even replicates may have another division of light than odd ones, unless there are but two.
std::vector<std::pair<std::size_t, std::size_t>> pairs_of(std::size_t replicates) {
  if (replicates == 2) return {{0, 1}};
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t r = 0; r + 2 < replicates; ++r) {
    if (r % 4 < 2) pairs.emplace_back(r, r + 2);
  }
  return pairs;
}

}  // namespace

LastingError::LastingError(std::uint64_t pixels, int replicates)
    : pixels_(pixels), replicates_(static_cast<std::size_t>(replicates)) {}

void LastingError::see(const std::vector<std::vector<float>>& light, double weight,
                       double samples_behind) {
  if (light.size() != replicates_ ||
      std::any_of(light.begin(), light.end(),
                  [&](const std::vector<float>& of) { return of.size() != pixels_; })) {
    throw std::invalid_argument("lasting error: pictures of another render");
  }
  std::vector<float> until_now;
  for (const auto& [first, second] : pairs_of(replicates_)) {
    for (std::size_t i = 0; i < pixels_; ++i) {
      until_now.push_back(static_cast<float>(weight) * (light[first][i] - light[second][i]));
    }
  }
  Stretch stretch{samples_behind, until_now};
  for (std::size_t i = 0; i < until_now_.size(); ++i) stretch.errors[i] -= until_now_[i];
  until_now_ = std::move(until_now);
  if (stretches_.size() > kBetween) {
    const Stretch& before = stretches_.front();
    if (const auto alike = visible_correlation(before.errors, stretch.errors)) {
      sum_ += *alike * std::sqrt(samples_behind / before.samples_behind);
      ++compared_;
    }
    stretches_.erase(stretches_.begin());
  }
  if (samples_behind > 0.0) stretches_.push_back(std::move(stretch));
}

std::optional<double> LastingError::share() const {
  if (compared_ == 0) return std::nullopt;
  return std::clamp(sum_ / static_cast<double>(compared_), 0.0, 1.0);
}

std::uint64_t LastingError::memory_bytes() const {
  return until_now_.size() * (1 + stretches_.size()) * sizeof(float);
}

void LastingError::save_state(OutputArchive& archive) const {
  archive(until_now_, stretches_, sum_, compared_);
}

void LastingError::load_state(InputArchive& archive) {
  archive(until_now_, stretches_, sum_, compared_);
  const std::size_t values = pairs_of(replicates_).size() * pixels_;
  const auto finite = [](const std::vector<float>& errors) {
    return std::all_of(errors.begin(), errors.end(), [](float e) { return std::isfinite(e); });
  };
  const bool fits = std::all_of(stretches_.begin(), stretches_.end(), [&](const Stretch& stretch) {
    return stretch.errors.size() == values && finite(stretch.errors) &&
           stretch.samples_behind > 0.0 && std::isfinite(stretch.samples_behind);
  });
  if (!fits || !finite(until_now_) || (!until_now_.empty() && until_now_.size() != values) ||
      stretches_.size() > kBetween + 1 || !std::isfinite(sum_)) {
    throw std::runtime_error("errors that last do not fit the render");
  }
}

}  // namespace ajar
