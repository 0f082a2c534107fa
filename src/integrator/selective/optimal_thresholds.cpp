#include "integrator/selective/optimal_thresholds.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace ajar {

namespace {

void check_argument(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

void check_costs(const ThresholdCosts& costs) {
  check_argument(costs.omc_sample > 0.0 && costs.mutation > 0.0 && costs.correlation > 0.0 &&
                     costs.base_variance >= 0.0,
                 "optimal thresholds: costs are not positive");
}

/// Lets each region take what is best for it while X and b stay about what they are.
std::vector<std::size_t> respond(std::span<const ThresholdEstimate> regions,
                                 const ThresholdCosts& costs, double variance) {
  // dX is worth as much as so many db.
  const double price = variance > 0.0
                           ? std::sqrt(costs.omc_sample / (costs.correlation * costs.mutation)) /
                                 (2.0 * std::sqrt(variance))
                           : 0.0;
  std::vector<std::size_t> chosen;
  chosen.reserve(regions.size());
  for (const ThresholdEstimate& region : regions) {
    std::size_t best = 0;
    const auto loss = [&](std::size_t i) { return region.variance[i] * price + region.light[i]; };
    for (std::size_t i = 1; i < region.light.size(); ++i) {
      if (loss(i) < loss(best)) best = i;
    }
    chosen.push_back(best);
  }
  return chosen;
}

}  // namespace

ThresholdChoice predict_thresholds(std::span<const ThresholdEstimate> regions,
                                   const ThresholdCosts& costs, std::vector<std::size_t> chosen) {
  check_costs(costs);
  check_argument(chosen.size() == regions.size(),
                 "optimal thresholds: there is not one per region");
  ThresholdChoice choice{std::move(chosen), costs.base_variance, 0.0, 0.0};
  for (std::size_t r = 0; r < regions.size(); ++r) {
    choice.variance += regions[r].variance.at(choice.chosen[r]);
    choice.chain_light += regions[r].light.at(choice.chosen[r]);
  }
  const double root = std::sqrt(choice.variance * costs.omc_sample) +
                      std::sqrt(costs.correlation * costs.mutation) * choice.chain_light;
  choice.error = root * root;
  return choice;
}

ThresholdChoice optimal_thresholds(std::span<const ThresholdEstimate> regions,
                                   const ThresholdCosts& costs) {
  if (regions.empty()) return predict_thresholds(regions, costs, {});
  const std::size_t count = regions.front().light.size();
  check_argument(count > 0, "optimal thresholds: there are none to choose from");
  for (const ThresholdEstimate& region : regions) {
    check_argument(region.light.size() == count && region.variance.size() == count,
                   "optimal thresholds: regions have different numbers of them");
  }
  ThresholdChoice best;
  for (std::size_t start = 0; start < count; ++start) {
    auto choice =
        predict_thresholds(regions, costs, std::vector<std::size_t>(regions.size(), start));
    if (start == 0) best = choice;
    // The error is a concave function of X, so every response to the tangent lowers it.
    constexpr int kMostRounds = 100;
    for (int round = 0; round < kMostRounds; ++round) {
      auto next = predict_thresholds(regions, costs, respond(regions, costs, choice.variance));
      if (!(next.error < choice.error)) break;
      choice = std::move(next);
    }
    if (choice.error < best.error) best = choice;
  }
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const auto same = [&](std::size_t i) {
      return regions[r].variance[i] == regions[r].variance[best.chosen[r]] &&
             regions[r].light[i] == regions[r].light[best.chosen[r]];
    };
    std::size_t lowest = 0;
    while (!same(lowest)) ++lowest;
    best.chosen[r] = lowest;
  }
  return best;
}

double best_mutations(double variance, double chain_light, const ThresholdCosts& costs) {
  check_costs(costs);
  if (!(variance > 0.0)) return 0.0;
  return std::sqrt(costs.correlation / variance * costs.omc_sample / costs.mutation) * chain_light;
}

}  // namespace ajar
