#include "post/denoise/mix_estimates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/parallel_for.h"
#include "image/plane.h"
#include "post/heuristics.h"

namespace ajar {

namespace {

void check_sizes(Vec2i size, const std::vector<BiasedEstimate>& estimates,
                 const Replicates& unbiased) {
  const std::size_t values =
      3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  const auto fits = [&](const std::vector<float>& picture) { return picture.size() == values; };
  const auto all_fit = [&](const Replicates& replicates) {
    return std::all_of(replicates.begin(), replicates.end(), fits);
  };
  const bool fine = !estimates.empty() && all_fit(unbiased) &&
                    std::all_of(estimates.begin(), estimates.end(), [&](const BiasedEstimate& e) {
                      return fits(e.pixels) && all_fit(e.parts) && e.parts.size() >= 2 &&
                             e.parts.size() <= unbiased.size() && all_fit(e.found) &&
                             (e.found.empty() || e.found.size() == unbiased.size());
                    });
  if (!fine) throw std::invalid_argument("mix_estimates: sizes do not fit");
}

/// One over the least of the smooth estimates, so that no clump makes its own error small; of black
/// values, over a little of the picture's level.
std::vector<float> scales_of(const std::vector<BiasedEstimate>& estimates) {
  std::vector<float> scales(estimates.front().pixels.size(),
                            std::numeric_limits<float>::infinity());
  for (const BiasedEstimate& estimate : estimates) {
    if (!estimate.is_smooth) continue;
    for (std::size_t i = 0; i < scales.size(); ++i) {
      scales[i] = std::min(scales[i], std::abs(estimate.pixels[i]));
    }
  }
  const auto floor = static_cast<float>(PostHeuristics::kDarkest * median_lit(scales));
  for (float& scale : scales) scale = 1.F / std::max({scale, floor, 1e-20F});
  return scales;
}

/// Mean of the replicates `part`, `part` + `parts`, …, of one value.
float mean_of_part(const Replicates& replicates, std::size_t part, std::size_t parts,
                   std::size_t value) {
  float sum = 0.F;
  float count = 0.F;
  for (std::size_t i = part; i < replicates.size(); i += parts) {
    sum += replicates[i][value];
    count += 1.F;
  }
  return sum / count;
}

/// (D_p − X_p) · (D_q − X_q) of one value, relative, mean over all pairs of parts.
float squared_bias(const Replicates& parts, const Replicates& unbiased, std::size_t value,
                   float scale) {
  float sum = 0.F;
  float squares = 0.F;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const float difference = parts[p][value] - mean_of_part(unbiased, p, parts.size(), value);
    // A firefly of one part is no sign of bias.
    const float counted = std::clamp(difference * scale, -PostHeuristics::kMostDifference,
                                     PostHeuristics::kMostDifference);
    sum += counted;
    squares += counted * counted;
  }
  const auto count = static_cast<float>(parts.size());
  return (sum * sum - squares) / (count * (count - 1.F));
}

/// Squared standard error of the mean of parts of one value, relative.
float variance(const Replicates& parts, std::size_t value, float scale) {
  const auto count = static_cast<float>(parts.size());
  float mean = 0.F;
  for (const std::vector<float>& part : parts) mean += part[value] / count;
  float sum = 0.F;
  for (const std::vector<float>& part : parts) {
    const float difference = (part[value] - mean) * scale;
    sum += difference * difference;
  }
  return sum / (count * (count - 1.F));
}

/// Squared errors of an estimate, relative, mean over channels and patches.
struct SquaredError {
  Plane noise;
  Plane bias;     ///< bias of a part
  Plane missing;  ///< share of `bias` from before the filter
  float parts = 1.F;

  float of_whole(std::size_t i) const {
    return noise.values[i] + missing.values[i] + (bias.values[i] - missing.values[i]) / parts;
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
        bias.at(x, y) += squared_bias(estimate.parts, unbiased, v, scales[v]) / 3.F;
        if (!estimate.found.empty()) {
          missing.at(x, y) += squared_bias(estimate.found, unbiased, v, scales[v]) / 3.F;
        }
        noise.at(x, y) += variance(estimate.parts, v, scales[v]) / 3.F;
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
  return {std::move(noise), std::move(bias), std::move(missing),
          static_cast<float>(estimate.parts.size())};
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
