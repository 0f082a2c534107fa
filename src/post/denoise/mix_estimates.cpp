#include "post/denoise/mix_estimates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/parallel_for.h"
#include "image/plane.h"
#include "post/heuristics.h"

namespace ajar {

namespace {

constexpr std::size_t kParts = 4;

void check_sizes(Vec2i size, const std::vector<BiasedEstimate>& estimates,
                 const Replicates& unbiased) {
  const std::size_t values =
      3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  const auto fits = [&](const std::vector<float>& picture) { return picture.size() == values; };
  const auto all_fit = [&](const Replicates& replicates) {
    return replicates.size() >= kParts && std::all_of(replicates.begin(), replicates.end(), fits);
  };
  const bool fine =
      !estimates.empty() && all_fit(unbiased) &&
      std::all_of(estimates.begin(), estimates.end(), [&](const BiasedEstimate& e) {
        return fits(e.pixels) && all_fit(e.replicates) && (e.found.empty() || all_fit(e.found));
      });
  if (!fine) throw std::invalid_argument("mix_estimates: sizes do not fit");
}

/// One over the mean of the estimates; of black values, over a little of the picture's level.
std::vector<float> scales_of(const std::vector<BiasedEstimate>& estimates) {
  std::vector<float> scales(estimates.front().pixels.size());
  for (const BiasedEstimate& estimate : estimates) {
    for (std::size_t i = 0; i < scales.size(); ++i) {
      scales[i] += std::abs(estimate.pixels[i]) / static_cast<float>(estimates.size());
    }
  }
  const auto floor = static_cast<float>(PostHeuristics::kDarkest * median_lit(scales));
  for (float& scale : scales) scale = 1.F / std::max({scale, floor, 1e-20F});
  return scales;
}

/// (D_a − X_b) · (D_c − X_d) of one value, relative, over all orders of four.
float squared_bias(const Replicates& biased, const Replicates& unbiased, std::size_t value,
                   float scale) {
  const auto difference = [&](std::size_t a, std::size_t b) {
    // A firefly of one replicate is no sign of bias.
    return std::clamp((biased[a][value] - unbiased[b][value]) * scale,
                      -PostHeuristics::kMostDifference, PostHeuristics::kMostDifference);
  };
  // Pairings of two replicates, with the other two free.
  constexpr std::array<std::array<std::size_t, kParts>, 6> kPairs = {
      {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};
  float sum = 0.F;
  for (const auto& [a, c, b, d] : kPairs) {
    sum += difference(a, b) * difference(c, d) + difference(a, d) * difference(c, b);
  }
  return sum / static_cast<float>(2 * kPairs.size());
}

/// Squared standard error of the mean of the replicates of one value, relative.
float variance(const BiasedEstimate& estimate, std::size_t value, float scale) {
  const auto count = static_cast<float>(estimate.replicates.size());
  float mean = 0.F;
  for (const std::vector<float>& replicate : estimate.replicates) mean += replicate[value] / count;
  float sum = 0.F;
  for (const std::vector<float>& replicate : estimate.replicates) {
    const float difference = (replicate[value] - mean) * scale;
    sum += difference * difference;
  }
  return sum / (count * (count - 1.F));
}

/// Squared errors of an estimate, relative, mean over channels and patches.
struct SquaredError {
  Plane noise;
  Plane bias;     ///< bias of a replicate
  Plane missing;  ///< part of `bias` from before the filter

  float of_whole(std::size_t i) const {
    return noise.values[i] + missing.values[i] + (bias.values[i] - missing.values[i]) / kParts;
  }
};
SquaredError squared_error(Vec2i size, const BiasedEstimate& estimate, const Replicates& unbiased,
                           const std::vector<float>& scales) {
  Plane bias(size);
  Plane noise(size);
  Plane missing(size);
  parallel_for(size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      const std::size_t first =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(x));
      for (std::size_t v = first; v < first + 3; ++v) {
        bias.at(x, y) += squared_bias(estimate.replicates, unbiased, v, scales[v]) / 3.F;
        if (!estimate.found.empty()) {
          missing.at(x, y) += squared_bias(estimate.found, unbiased, v, scales[v]) / 3.F;
        }
        noise.at(x, y) += variance(estimate, v, scales[v]) / 3.F;
      }
    }
  });
  const SeparableKernel kernel = gaussian_kernel(PostHeuristics::kErrorPatch);
  bias = filter_plane(bias, kernel);
  noise = filter_plane(noise, kernel);
  if (!estimate.found.empty()) missing = filter_plane(missing, kernel);
  for (std::size_t i = 0; i < bias.values.size(); ++i) {
    bias.values[i] = std::max(0.F, bias.values[i]);
    missing.values[i] = std::clamp(missing.values[i], 0.F, bias.values[i]);
  }
  return {std::move(noise), std::move(bias), std::move(missing)};
}

}  // namespace

MixedEstimate mix_estimates(Vec2i size, const std::vector<BiasedEstimate>& estimates,
                            const Replicates& unbiased) {
  check_sizes(size, estimates, unbiased);
  const std::vector<float> scales = scales_of(estimates);
  std::vector<SquaredError> errors;
  errors.reserve(estimates.size());
  for (const BiasedEstimate& estimate : estimates) {
    errors.push_back(squared_error(size, estimate, unbiased, scales));
  }
  MixedEstimate mixed;
  mixed.pixels.resize(scales.size());
  mixed.error.resize(scales.size());
  mixed.shares.assign(estimates.size(), std::vector<float>(scales.size() / 3));
  for (std::size_t i = 0; i < scales.size() / 3; ++i) {
    float least = std::numeric_limits<float>::infinity();
    for (const SquaredError& error : errors) least = std::min(least, error.of_whole(i));
    float whole = 0.F;
    for (std::size_t e = 0; e < estimates.size(); ++e) {
      // Relative to the best, which may have none.
      const float own = errors[e].of_whole(i);
      const float ratio = own > least ? least / own : 1.F;
      mixed.shares[e][i] = ratio * ratio;
      whole += mixed.shares[e][i];
    }
    float error = 0.F;
    for (std::size_t e = 0; e < estimates.size(); ++e) {
      float& share = mixed.shares[e][i];
      share /= whole;
      error += share * errors[e].of_whole(i);
      for (std::size_t v = 3 * i; v < 3 * i + 3; ++v) {
        mixed.pixels[v] += share * estimates[e].pixels[v];
      }
    }
    for (std::size_t v = 3 * i; v < 3 * i + 3; ++v) mixed.error[v] = std::sqrt(error) / scales[v];
  }
  return mixed;
}

std::vector<float> without_fireflies(const std::vector<float>& picture,
                                     const Replicates& replicates,
                                     const std::vector<float>& filtered) {
  const std::vector<float> median = replicate_median(replicates);
  std::vector<float> result = picture;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (result[i] - filtered[i] > PostHeuristics::kMostDifference * std::abs(filtered[i])) {
      result[i] = std::min(result[i], std::max(median[i], filtered[i]));
    }
  }
  return result;
}

}  // namespace ajar
