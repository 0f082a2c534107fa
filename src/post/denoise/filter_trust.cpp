#include "post/denoise/filter_trust.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "image/plane.h"
#include "post/heuristics.h"

namespace ajar {

namespace {

constexpr std::size_t kParts = 4;

/// What errors are relative to: of black pixels, to a little of the picture's level.
std::vector<float> scales_of(const std::vector<float>& filtered) {
  const auto floor = static_cast<float>(0.01 * median_lit(filtered));
  std::vector<float> scales(filtered.size());
  std::transform(filtered.begin(), filtered.end(), scales.begin(), [&](float value) {
    return 1.F / std::max({std::abs(value), floor, 1e-20F});
  });
  return scales;
}

/// Mean over the three channels, averaged over a patch.
Plane over_patches(Vec2i size, const std::vector<float>& values) {
  Plane plane(size);
  for (std::size_t i = 0; i < plane.values.size(); ++i) {
    plane.values[i] = (values[3 * i] + values[3 * i + 1] + values[3 * i + 2]) / 3.F;
  }
  const double sigma = PostHeuristics::kTrustPatch;
  const std::vector<double> weights =
      gaussian_weights(static_cast<int>(std::ceil(3.0 * sigma)), sigma);
  double sum = 0.0;
  for (const double weight : weights) sum += weight;
  SeparableKernel kernel;
  for (const double weight : weights) kernel.x.push_back(static_cast<float>(weight / sum));
  kernel.y = kernel.x;
  return filter_plane(plane, kernel);
}

/// Squared standard error of the mean, relative.
std::vector<float> relative_variance(const Replicates& replicates,
                                     const std::vector<float>& scales) {
  std::vector<float> variance = standard_error(replicates);
  for (std::size_t i = 0; i < variance.size(); ++i) {
    variance[i] *= scales[i];
    variance[i] *= variance[i];
  }
  return variance;
}

/// (D_a − X_b) · (D_c − X_d), relative, over all orders of four.
std::vector<float> squared_bias(const Replicates& replicates, const Replicates& filtered,
                                const std::vector<float>& scales) {
  std::vector<float> result(scales.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto difference = [&](std::size_t a, std::size_t b) {
      // A firefly of one replicate is no sign of bias.
      return std::clamp((filtered[a][i] - replicates[b][i]) * scales[i],
                        -PostHeuristics::kMostDifference, PostHeuristics::kMostDifference);
    };
    float sum = 0.F;
    int orders = 0;
    for (std::size_t a = 0; a < kParts; ++a) {
      for (std::size_t c = a + 1; c < kParts; ++c) {
        std::array<std::size_t, 2> rest{};
        std::size_t count = 0;
        for (std::size_t k = 0; k < kParts; ++k) {
          if (k != a && k != c) rest[count++] = k;
        }
        sum += difference(a, rest[0]) * difference(c, rest[1]) +
               difference(a, rest[1]) * difference(c, rest[0]);
        orders += 2;
      }
    }
    result[i] = sum / static_cast<float>(orders);
  }
  return result;
}

}  // namespace

FilterTrust trust_filter(Vec2i size, const std::vector<float>& unfiltered,
                         const std::vector<float>& filtered, const Replicates& replicates,
                         const Replicates& filtered_replicates) {
  const std::size_t values =
      3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  const auto fits = [&](const std::vector<float>& picture) { return picture.size() == values; };
  if (replicates.size() < kParts || filtered_replicates.size() != replicates.size() ||
      !fits(unfiltered) || !fits(filtered) ||
      !std::all_of(replicates.begin(), replicates.end(), fits) ||
      !std::all_of(filtered_replicates.begin(), filtered_replicates.end(), fits)) {
    throw std::invalid_argument("trust_filter: replicates are missing, or sizes do not fit");
  }
  const std::vector<float> scales = scales_of(filtered);
  const Plane bias = over_patches(size, squared_bias(replicates, filtered_replicates, scales));
  const Plane raw = over_patches(size, relative_variance(replicates, scales));
  const Plane smooth = over_patches(size, relative_variance(filtered_replicates, scales));
  FilterTrust trust{filtered, std::vector<float>(values / 3), std::vector<float>(values)};
  for (std::size_t i = 0; i < trust.unfiltered.size(); ++i) {
    const float harm = std::max(0.F, bias.values[i]) + smooth.values[i];
    const float whole = raw.values[i] + harm;
    const float share = whole > 0.F ? harm / whole : 0.F;
    trust.unfiltered[i] = share;
    const float error = std::sqrt(share * share * raw.values[i] + (1 - share) * (1 - share) * harm);
    for (std::size_t v = 3 * i; v < 3 * i + 3; ++v) {
      trust.pixels[v] = share * unfiltered[v] + (1 - share) * filtered[v];
      trust.error[v] = error / scales[v];
    }
  }
  return trust;
}

}  // namespace ajar
