#include "integrator/selective/optimal_weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "integrator/selective/check_argument.h"

namespace ajar {

namespace {

void check_regions(std::span<const RegionEstimate> regions) {
  for (const RegionEstimate& region : regions) {
    // Written so that NaN fails.
    check_argument(region.variance >= 0.0,
                   "optimal weights: a variance is negative or not a number");
    check_argument(region.light >= 0.0 && std::isfinite(region.light),
                   "optimal weights: the light of a region is negative or not finite");
    check_argument(
        0.0 <= region.minimum && region.minimum <= region.maximum && region.maximum <= 1.0,
        "optimal weights: the bounds of a region are not an interval in [0, 1]");
  }
}

bool is_positive(double value) { return value > 0.0 && std::isfinite(value); }

void check_effort(const Effort& effort) {
  check_argument(is_positive(effort.omc_samples) && is_positive(effort.mutations),
                 "optimal weights: both halves need samples");
  check_argument(effort.correlation >= 0.0 && std::isfinite(effort.correlation),
                 "optimal weights: the correlation of the chains is negative or not finite");
}

/// Best σ of a region if the chains' light is `chain_light`; `slope` is C·n/N, or half of it.
double best_weight(const RegionEstimate& region, double slope, double chain_light) {
  if (region.variance == 0.0) return region.minimum;
  const double weight = 1.0 - slope * region.light * chain_light / region.variance;
  return std::clamp(weight, region.minimum, region.maximum);
}

/// b of the best weights, if chains render `chain_light`.
double light_after(std::span<const RegionEstimate> regions, double slope, double chain_light) {
  double sum = 0.0;
  for (const RegionEstimate& region : regions) {
    sum += region.light * best_weight(region, slope, chain_light);
  }
  return sum;
}

}  // namespace

OptimalWeights predict_error(std::span<const RegionEstimate> regions, const Effort& effort,
                             std::span<const double> weights) {
  check_regions(regions);
  check_effort(effort);
  check_argument(weights.size() == regions.size(),
                 "optimal weights: there is not one weight per region");
  OptimalWeights result{{weights.begin(), weights.end()}, 0.0, 0.0, 0.0};
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const double rest = 1.0 - weights[r];
    // Infinite variance does no harm where none of it is left.
    if (rest != 0.0) result.omc_error += rest * rest * regions[r].variance / effort.omc_samples;
    result.chain_light += regions[r].light * weights[r];
  }
  result.chain_error =
      effort.correlation * result.chain_light * result.chain_light / effort.mutations;
  return result;
}

OptimalWeights optimal_weights(std::span<const RegionEstimate> regions, const Effort& effort,
                               WeightRule rule) {
  check_regions(regions);
  check_effort(effort);
  const double slope = effort.correlation * effort.omc_samples / effort.mutations *
                       (rule == WeightRule::Pixel ? 0.5 : 1.0);
  double low = 0.0;
  double high = 0.0;
  for (const RegionEstimate& region : regions) {
    low += region.light * region.minimum;
    high += region.light * region.maximum;
  }
  while (true) {
    const double middle = std::midpoint(low, high);
    if (!(low < middle && middle < high)) break;  // the two are neighbours
    (light_after(regions, slope, middle) > middle ? low : high) = middle;
  }
  std::vector<double> weights;
  weights.reserve(regions.size());
  for (const RegionEstimate& region : regions) weights.push_back(best_weight(region, slope, high));
  return predict_error(regions, effort, weights);
}

TimeSplit optimal_split(std::span<const RegionEstimate> regions, const RenderCosts& costs) {
  check_argument(is_positive(costs.seconds) && is_positive(costs.seconds_per_omc_sample) &&
                     is_positive(costs.seconds_per_mutation),
                 "optimal split: times are not positive");
  check_argument(costs.omc_only_variance >= 0.0,
                 "optimal split: a variance is negative or not a number");
  const auto split_at = [&](double share) {
    TimeSplit split;
    split.omc_share = share;
    split.effort = {share * costs.seconds / costs.seconds_per_omc_sample,
                    (1.0 - share) * costs.seconds / costs.seconds_per_mutation, costs.correlation};
    split.weights = optimal_weights(regions, split.effort);
    split.weights.omc_error += costs.omc_only_variance / split.effort.omc_samples;
    return split;
  };
  // Fifty steps leave the share at least 2^-50 away from 0 and 1, where nothing can be bought.
  constexpr int kSteps = 50;
  double low = 0.0;
  double high = 1.0;
  TimeSplit split;
  for (int step = 0; step < kSteps; ++step) {
    split = split_at(0.5 * (low + high));
    const double share = split.omc_share;
    const bool chains_need_more =
        split.weights.chain_error * share > split.weights.omc_error * (1.0 - share);
    (chains_need_more ? high : low) = share;
  }
  return split;
}

}  // namespace ajar
