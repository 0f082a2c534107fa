#include "integrator/region_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "image/noise.h"
#include "image/optimal_thresholds.h"
#include "image/optimal_weights.h"
#include "image/pixel_at.h"
#include "integrator/path_family.h"
#include "integrator/weighted_errors.h"

namespace ajar {

namespace {

constexpr double kRaysPerMutation = 4.5;

/// Thresholds to choose from, relative to the lowest; and one for chains on standby. None in
/// between: what is left to ordinary Monte Carlo would show as fireflies.
constexpr std::array kThresholds = {1.0, 3.0, 10.0, 100.0};
constexpr std::size_t kOffered = 3;

bool is_seen(const PilotView& view, int replicate) {
  return std::find(view.replicates.begin(), view.replicates.end(), replicate) !=
         view.replicates.end();
}

/// Samples per pixel of the replicates that are seen.
double seen_samples(const PilotView& view) {
  return static_cast<double>(view.samples) * static_cast<double>(view.replicates.size()) /
         view.film.replicates();
}

/// Pictures of the replicates that are seen: the sum of some layers.
Replicates seen_pictures(const PilotView& view, std::initializer_list<std::string> names) {
  const Replicates all = develop_layers(view.film, view.omc, view.samples, names);
  Replicates seen;
  for (const int r : view.replicates) seen.push_back(all[static_cast<std::size_t>(r)]);
  return seen;
}

/// Of one sample of each pixel, from the spread of replicates.
WeightedErrors sample_errors(const PilotView& view, std::initializer_list<std::string> names) {
  WeightedErrors errors = weighted_errors(seen_pictures(view, names), view.plan.settings.crop,
                                          view.plan.view.importance);
  for (double& variance : errors.variance) variance *= seen_samples(view);
  return errors;
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double omc_cost(const PilotView& view) {
  return view.rays * static_cast<double>(view.plan.pixels());
}

/// What rules and presets fix.
std::vector<std::optional<float>> fixed_weights(const PilotView& view) {
  const SelectiveSettings& settings = *view.plan.selective;
  const Scene& scene = view.plan.scene;
  std::vector<std::optional<float>> fixed;
  for (const PixelIdentity& identity : view.regions.identities) {
    std::optional<float>& weight = fixed.emplace_back();
    // 0 is "nothing there": the environment.
    if (identity.object == 0 || identity.material == 0) continue;
    const std::size_t material = identity.material - 1;
    if (settings.diffuse_out && scene.is_diffuse(material)) weight = settings.binary.epsilon;
    const RegionRule* rule =
        find_region_rule(settings.rules, scene.object_names()[identity.object - 1],
                         scene.material_names()[material]);
    if (rule != nullptr) weight = fixed_weight(*rule, settings.binary.epsilon);
  }
  return fixed;
}

/// Variance and light that each threshold would leave to either side.
std::vector<ThresholdEstimate> estimate_thresholds(const PilotView& view) {
  const std::size_t count = kThresholds.size() + 1;  // the last: none
  std::vector<ThresholdEstimate> regions(view.regions.count(),
                                         {std::vector<double>(count), std::vector<double>(count)});
  const double samples = seen_samples(view);
  // A firefly cannot look worse than white, so that a brighter one is no better reason for chains.
  constexpr double kWhite = 100.0;
  const double most = kWhite * view.plan.brightness;
  const double lowest = *view.plan.split_at * view.plan.brightness;
  for (const FoundLight& found : view.found) {
    if (!is_seen(view, found.replicate)) continue;
    ThresholdEstimate& region =
        regions[view.regions.labels[pixel_at(view.plan.settings.crop, found.raster)]];
    const double energy = std::min(std::abs(found.energy), most);
    for (std::size_t i = 0; i < count; ++i) {
      const double above =
          i < kThresholds.size()
              ? static_cast<double>(LightSplit::above(
                    found.strength, static_cast<float>(kThresholds.at(i) * lowest)))
              : 0.0;
      const double omc = energy * (1.0 - above);
      region.variance[i] += found.weight * omc * omc / samples;
      region.light[i] += found.weight * energy * above / samples;
    }
  }
  return regions;
}

/// Puts regions of which the pilot has seen too little to tell them apart together with others of
/// their material, and if that is still too little, with all such: the choice for a region would
/// otherwise follow its noise.
std::vector<std::size_t> group_regions(const PilotView& view) {
  constexpr std::size_t kFewest = 50;
  constexpr float kBright = 0.25F;
  const float lowest = static_cast<float>(*view.plan.split_at * view.plan.brightness);
  std::vector<std::size_t> seen(view.regions.count());
  std::map<std::uint32_t, std::size_t> seen_of_material;
  for (const FoundLight& found : view.found) {
    if (!is_seen(view, found.replicate)) continue;
    if (LightSplit::above(found.strength, lowest) < kBright) continue;
    const std::uint32_t region =
        view.regions.labels[pixel_at(view.plan.settings.crop, found.raster)];
    ++seen[region];
    ++seen_of_material[view.regions.identities[region].material];
  }
  // Groups: regions, then materials, then one for the rest.
  std::vector<std::size_t> groups;
  std::map<std::uint32_t, std::size_t> group_of_material;
  for (std::size_t r = 0; r < seen.size(); ++r) {
    const std::uint32_t material = view.regions.identities[r].material;
    if (seen[r] >= kFewest) {
      groups.push_back(r);
    } else if (seen_of_material[material] >= kFewest) {
      groups.push_back(seen.size() + 1 + material);
    } else {
      groups.push_back(seen.size());
    }
  }
  return groups;
}

/// What ordinary Monte Carlo makes whatever the thresholds are.
double base_variance(const PilotView& view, const std::vector<ThresholdEstimate>& regions) {
  double divided = 0.0;
  for (const ThresholdEstimate& region : regions) divided += region.variance.front();
  return std::max(0.0, sum_of(sample_errors(view, {"direct", kWeakLayer}).variance) - divided);
}

RegionChoice choose_thresholds(const PilotView& view) {
  const std::vector<ThresholdEstimate> regions = estimate_thresholds(view);
  const ThresholdCosts costs{omc_cost(view), kRaysPerMutation, view.correlation,
                             base_variance(view, regions)};
  const std::vector<std::size_t> groups = group_regions(view);
  std::map<std::size_t, std::size_t> order;
  std::vector<ThresholdEstimate> offered;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const auto [place, is_new] = order.emplace(groups[r], offered.size());
    if (is_new) {
      offered.push_back({std::vector<double>(kOffered), std::vector<double>(kOffered)});
    }
    for (std::size_t i = 0; i < kOffered; ++i) {
      offered[place->second].variance[i] += regions[r].variance[i];
      offered[place->second].light[i] += regions[r].light[i];
    }
  }
  const ThresholdChoice of_groups = optimal_thresholds(offered, costs);
  std::vector<std::size_t> chosen;
  chosen.reserve(groups.size());
  for (const std::size_t group : groups) chosen.push_back(of_groups.chosen[order.at(group)]);
  const ThresholdChoice without = predict_thresholds(
      regions, costs, std::vector<std::size_t>(regions.size(), kThresholds.size()));
  RegionChoice choice;
  // They must bring more than it costs to have them. Where the pilot has found nothing for them,
  // they cost nothing, and stay ready.
  constexpr double kClearly = 0.98;
  choice.off = of_groups.chain_light > 0.0 && kClearly * without.error <= of_groups.error;
  if (choice.off) chosen.assign(regions.size(), kThresholds.size() - 1);
  const auto lowest = static_cast<float>(*view.plan.split_at * view.plan.brightness);
  const auto fixed = fixed_weights(view);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (fixed[r]) chosen[r] = 0;
    const float weight = fixed[r].value_or(1.F);
    choice.shares.push_back(
        {lowest * static_cast<float>(kThresholds.at(chosen[r])), weight, weight});
    choice.off = choice.off && !fixed[r];
  }
  const ThresholdChoice final = predict_thresholds(regions, costs, chosen);
  choice.mutations = best_mutations(final.variance, final.chain_light, costs) /
                     static_cast<double>(view.plan.pixels());
  return choice;
}

/// σ of each region, and what it takes.
RegionChoice choose_weights(const PilotView& view) {
  const SelectiveSettings& settings = *view.plan.selective;
  const Regions& regions = view.regions;
  const WeightedErrors indirect = sample_errors(view, {"indirect", kWeakLayer});
  std::vector<RegionEstimate> estimates(regions.count());
  for (std::size_t i = 0; i < indirect.light.size(); ++i) {
    estimates[regions.labels[i]].variance += indirect.variance[i];
    estimates[regions.labels[i]].light += indirect.light[i];
  }
  std::vector<float> published(regions.count(), 1.F);
  if (settings.map == SelectiveSettings::Map::Binary) {
    published = region_map(replicate_mean(seen_pictures(view, {"indirect", kWeakLayer})), regions,
                           settings.binary);
  }
  const auto fixed = fixed_weights(view);
  for (std::size_t r = 0; r < estimates.size(); ++r) {
    std::optional<float> weight = fixed[r];
    if (!weight && settings.map == SelectiveSettings::Map::Binary) weight = published[r];
    if (weight) estimates[r].minimum = estimates[r].maximum = static_cast<double>(*weight);
  }
  const TimeSplit split =
      optimal_split(estimates, {1.0, omc_cost(view), kRaysPerMutation, view.correlation,
                                sum_of(sample_errors(view, {"direct"}).variance)});
  RegionChoice choice;
  for (std::size_t r = 0; r < estimates.size(); ++r) {
    const auto weight = static_cast<float>(split.weights.weights[r]);
    choice.shares.push_back({0.F, weight, weight});
  }
  choice.off = !(split.weights.chain_light > 0.0);
  choice.mutations =
      split.effort.mutations / split.effort.omc_samples / static_cast<double>(view.plan.pixels());
  return choice;
}

/// Formulas 5 and 6 of METHODS, section 4: what is left to ordinary Monte Carlo is made by it
/// alone, the rest by chains alone.
void make_exclusive(const SelectiveSettings& settings, std::vector<PixelShare>& shares) {
  const float limit =
      settings.map == SelectiveSettings::Map::Binary ? settings.binary.epsilon : 0.5F;
  for (PixelShare& share : shares) share.kept = share.target <= limit ? 0.F : 1.F;
}

}  // namespace

Plane pilot_noise(const PilotView& view) {
  return impulse_noise(view.regions.size,
                       replicate_mean(seen_pictures(view, {"indirect", kWeakLayer})),
                       view.plan.selective->binary.window);
}

RegionChoice choose_regions(const PilotView& view) {
  const SelectiveSettings& settings = *view.plan.selective;
  const bool path_by_path = view.plan.split_at && settings.map == SelectiveSettings::Map::Optimal;
  RegionChoice choice = path_by_path ? choose_thresholds(view) : choose_weights(view);
  if (view.plan.split_at && !path_by_path) {
    const auto lowest = static_cast<float>(*view.plan.split_at * view.plan.brightness);
    for (PixelShare& share : choice.shares) share.threshold = lowest;
  }
  if (settings.exclusive) make_exclusive(settings, choice.shares);
  for (const RegionNoise& noise :
       aggregate_noise(pilot_noise(view), view.regions, settings.binary.threshold)) {
    choice.noise.push_back(noise.fill());
  }
  return choice;
}

}  // namespace ajar
