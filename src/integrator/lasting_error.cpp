#include "integrator/lasting_error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/archive.h"
#include "image/visible_error.h"

namespace ajar {

namespace {

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

void LastingError::see(const std::vector<std::vector<float>>& light, double weight,
                       double samples_behind) {
  std::vector<float> until_now;
  for (const auto& [first, second] : pairs_of(light.size())) {
    for (std::size_t i = 0; i < light[first].size(); ++i) {
      until_now.push_back(static_cast<float>(weight) * (light[first][i] - light[second][i]));
    }
  }
  std::vector<float> stretch = until_now;
  for (std::size_t i = 0; i < until_now_.size(); ++i) stretch[i] -= until_now_[i];
  if (const auto alike =
          samples_behind_ > 0.0 ? visible_correlation(stretch_, stretch) : std::nullopt) {
    sum_ += std::clamp(*alike * std::sqrt(samples_behind / samples_behind_), 0.0, kMost);
    ++stretches_;
  }
  until_now_ = std::move(until_now);
  stretch_ = std::move(stretch);
  samples_behind_ = samples_behind;
}

std::uint64_t LastingError::memory_bytes() const {
  return (until_now_.size() + stretch_.size()) * sizeof(float);
}

void LastingError::save_state(OutputArchive& archive) const {
  archive(until_now_, stretch_, samples_behind_, sum_, stretches_);
}

void LastingError::load_state(InputArchive& archive) {
  archive(until_now_, stretch_, samples_behind_, sum_, stretches_);
  if (until_now_.size() != stretch_.size() || !(samples_behind_ >= 0.0) || !std::isfinite(sum_)) {
    throw std::runtime_error("errors that last do not fit the render");
  }
}

}  // namespace ajar
