#include "integrator/selective/region_choice.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "image/pixel_at.h"
#include "integrator/division.h"
#include "integrator/regions/impulse_noise.h"
#include "integrator/selective/heuristics.h"
#include "integrator/selective/optimal_thresholds.h"
#include "integrator/selective/optimal_weights.h"
#include "integrator/selective/weighted_errors.h"

namespace ajar {

namespace {

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

double omc_cost(const PilotView& view) {
  return view.rays * static_cast<double>(view.plan.pixels());
}

/// A state of `pssmlt` is a whole sample.
double rays_per_mutation(const PilotView& view) {
  return view.plan.kind == ChainKind::WholePath ? view.rays : SelectiveHeuristics::kRaysPerMutation;
}

/// What rules and presets fix.
std::vector<std::optional<float>> fixed_weights(const PilotView& view) {
  if (!view.plan.selective) return std::vector<std::optional<float>>(view.regions.count());
  const SelectiveSettings& settings = *view.plan.selective;
  const Scene& scene = view.plan.scene;
  std::vector<std::optional<float>> fixed;
  for (const PixelIdentity& identity : view.regions.identities) {
    std::optional<float>& weight = fixed.emplace_back();
    // 0 is "nothing there": the environment.
    if (identity.object == 0 || identity.material == 0) continue;
    const std::size_t material = identity.material - 1;
    if (settings.diffuse_out &&
        scene.material(static_cast<desc::MaterialId>(material)).is_diffuse()) {
      weight = settings.binary.epsilon;
    }
    const RegionRule* rule =
        find_region_rule(settings.rules, scene.object_names()[identity.object - 1],
                         scene.material_names()[material]);
    if (rule != nullptr) weight = fixed_weight(*rule, settings.binary.epsilon);
  }
  return fixed;
}

/// Those of the plan, and that of chains on standby.
std::vector<double> all_thresholds(const ChainPlan& plan) {
  std::vector<double> thresholds = plan.thresholds;
  thresholds.push_back(plan.standby_threshold);
  return thresholds;
}

/// A path of the pilot, as chains and ordinary Monte Carlo may share it.
struct SharedPath {
  std::uint64_t sample;   ///< that found it
  std::size_t replicate;  ///< among those that are seen
  std::size_t pixel;
  float strength;
  float light;  ///< luminance · importance in a picture of its replicate
  float lot;    ///< share of its square that is due to its being drawn by lot
};

/// Which paths of the pilot count.
struct PathsSeen {
  double most;             ///< for no more than so many times the brightness of the picture
  bool without_brightest;  ///< camera sample
};

/// Leaves out all paths of the sample that brings most. They are in the order of samples.
void erase_brightest(std::vector<SharedPath>& paths) {
  auto first = paths.end();
  auto last = paths.end();
  double most = 0.0;
  for (auto run = paths.begin(); run != paths.end();) {
    auto end = run;
    double light = 0.0;
    for (; end != paths.end() && end->sample == run->sample; ++end) {
      light += static_cast<double>(std::abs(end->light));
    }
    if (light > most) {
      most = light;
      first = run;
      last = end;
    }
    run = end;
  }
  paths.erase(first, last);
}

std::vector<SharedPath> shared_paths(const PilotView& view, const PathsSeen& seen) {
  const auto most = static_cast<float>(seen.most * view.plan.brightness);
  const auto scale =
      static_cast<float>(static_cast<double>(view.replicates.size()) / seen_samples(view));
  std::vector<SharedPath> paths;
  for (const FoundLight& found : view.found) {
    const auto place = std::find(view.replicates.begin(), view.replicates.end(), found.replicate);
    if (place == view.replicates.end()) continue;
    paths.push_back({found.sample, static_cast<std::size_t>(place - view.replicates.begin()),
                     pixel_at(view.plan.settings.crop, found.raster), found.strength,
                     std::clamp(found.energy, -most, most) * found.weight * scale,
                     1.F - 1.F / found.weight});
  }
  if (seen.without_brightest) erase_brightest(paths);
  return paths;
}

/// Variance and light that each of `thresholds`, and none, would leave to either side.
std::vector<ThresholdEstimate> estimate_thresholds(const PilotView& view,
                                                   const std::vector<double>& thresholds,
                                                   const PathsSeen& seen) {
  const std::size_t count = thresholds.size() + 1;
  std::vector<ThresholdEstimate> regions(view.regions.count(),
                                         {std::vector<double>(count), std::vector<double>(count)});
  const std::vector<std::vector<float>> weak =
      weighted_light(seen_pictures(view, {"direct", kWeakLayer}), view.plan.settings.crop,
                     view.plan.view.importance);
  const std::vector<SharedPath> paths = shared_paths(view, seen);
  const auto lowest = static_cast<float>(view.plan.lowest_threshold());
  // Fireflies that no threshold helps against, of direct light, say, must decide nothing.
  const std::vector<double> least = trimmed(variance_of_mean(weak));
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::vector<float>> light = weak;
    std::vector<double> by_lot(light.front().size());
    for (const SharedPath& path : paths) {
      const float above =
          i < thresholds.size()
              ? Division::above(path.strength,
                                static_cast<float>(thresholds[i] * view.plan.brightness))
              : 0.F;
      const float more = path.light * (Division::above(path.strength, lowest) - above);
      light[path.replicate][path.pixel] += more;
      by_lot[path.pixel] += static_cast<double>(more * more * path.lot);
      regions[view.regions.labels[path.pixel]].light[i] +=
          static_cast<double>(std::abs(path.light) * above) /
          static_cast<double>(view.replicates.size());
    }
    const std::vector<double> variance = variance_of_mean(light);
    const auto pictures = static_cast<double>(light.size());
    for (std::size_t p = 0; p < variance.size(); ++p) {
      if (least[p] == 0.0) continue;
      regions[view.regions.labels[p]].variance[i] +=
          (variance[p] - by_lot[p] / (pictures * pictures)) * seen_samples(view);
    }
  }
  // Chains that make less leave no smaller variance, whatever a few samples say.
  for (ThresholdEstimate& region : regions) {
    double most = 0.0;
    for (double& variance : region.variance) {
      most = std::max(most, variance);
      variance = most;
    }
  }
  return regions;
}

/// Puts regions of which the pilot has seen too little to tell them apart together with others of
/// their material, and if that is still too little, with all such: the choice for a region would
/// otherwise follow its noise.
std::vector<std::size_t> group_regions(const PilotView& view) {
  std::vector<std::size_t> seen(view.regions.count());
  std::map<std::uint32_t, std::size_t> seen_of_material;
  for (const FoundLight& found : view.found) {
    if (!is_seen(view, found.replicate)) continue;
    if (static_cast<double>(found.strength) < SelectiveHeuristics::kBright * view.plan.brightness) {
      continue;
    }
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
    if (seen[r] >= SelectiveHeuristics::kFewestOfRegion) {
      groups.push_back(r);
    } else if (seen_of_material[material] >= SelectiveHeuristics::kFewestOfRegion) {
      groups.push_back(seen.size() + 1 + material);
    } else {
      groups.push_back(seen.size());
    }
  }
  return groups;
}

/// What a choice is made of: regions, put together as `group_regions` has it, and thresholds other
/// than that of chains on standby.
struct OfferedThresholds {
  std::vector<std::size_t> group_of;  ///< of each region
  std::vector<ThresholdEstimate> groups;
};

OfferedThresholds offer_thresholds(const PilotView& view,
                                   const std::vector<ThresholdEstimate>& regions) {
  const std::size_t offers = view.plan.thresholds.size();
  std::map<std::size_t, std::size_t> order;
  OfferedThresholds offered;
  for (const std::size_t group : group_regions(view)) {
    const auto [place, is_new] = order.emplace(group, offered.groups.size());
    if (is_new) {
      offered.groups.push_back({std::vector<double>(offers), std::vector<double>(offers)});
    }
    offered.group_of.push_back(place->second);
  }
  for (std::size_t r = 0; r < regions.size(); ++r) {
    ThresholdEstimate& group = offered.groups[offered.group_of[r]];
    for (std::size_t i = 0; i < offers; ++i) {
      group.variance[i] += regions[r].variance[i];
      group.light[i] += regions[r].light[i];
    }
  }
  return offered;
}

/// Predicted error with chains over that without, if they are as much worse as one may doubt.
double gain_of_chains(const PilotView& view, const std::vector<double>& thresholds,
                      ThresholdCosts costs, const PathsSeen& seen) {
  costs.correlation *= SelectiveHeuristics::kDoubt;
  const std::vector<ThresholdEstimate> regions = estimate_thresholds(view, thresholds, seen);
  const ThresholdChoice without = predict_thresholds(
      regions, costs, std::vector<std::size_t>(regions.size(), thresholds.size()));
  return optimal_thresholds(offer_thresholds(view, regions).groups, costs).error / without.error;
}

/// How much more than to stand by chains should do, from 0 to 1. Around a gain that is clear enough
/// it is a matter of degree: the halves of the replicates decide each for itself, and if one did
/// with chains what the other does without, the picture would have the noise of the one at the cost
/// of the other.
double trust_in(double gain) {
  return std::clamp((SelectiveHeuristics::kClearGain - gain) / SelectiveHeuristics::kDoubtfulGains,
                    0.0, 1.0);
}

ThresholdCosts threshold_costs(const PilotView& view) {
  return {omc_cost(view), rays_per_mutation(view), view.correlation, 0.0};
}

RegionChoice choose_thresholds(const PilotView& view) {
  const std::vector<double> thresholds = all_thresholds(view.plan);
  const std::vector<ThresholdEstimate> regions =
      estimate_thresholds(view, thresholds, {SelectiveHeuristics::kWhite, false});
  const ThresholdCosts costs = threshold_costs(view);
  const OfferedThresholds offered = offer_thresholds(view, regions);
  const ThresholdChoice of_groups = optimal_thresholds(offered.groups, costs);
  RegionChoice choice;
  double trust = 1.0;
  // Where the pilot has found nothing for them, they cost nothing, and stay ready.
  if (view.plan.selective && of_groups.chain_light > 0.0) {
    // No single sample is evidence.
    choice.expected_error =
        gain_of_chains(view, thresholds, costs, {SelectiveHeuristics::kWhite, true});
    trust = trust_in(choice.expected_error);
    choice.off = trust == 0.0 &&
                 gain_of_chains(view, thresholds, costs, {SelectiveHeuristics::kGlaring, false}) >=
                     SelectiveHeuristics::kClearGain;
  }
  std::vector<std::size_t> chosen;
  chosen.reserve(regions.size());
  for (const std::size_t group : offered.group_of) chosen.push_back(of_groups.chosen[group]);
  const auto fixed = fixed_weights(view);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (fixed[r]) chosen[r] = 0;
    const double threshold = fixed[r] ? thresholds[chosen[r]]
                                      : std::pow(thresholds[chosen[r]], trust) *
                                            std::pow(thresholds.back(), 1.0 - trust);
    // Chains that nothing can seed cannot stand by either.
    const bool none = choice.off && !view.plan.has_recruits();
    const float weight = fixed[r].value_or(none ? 0.F : 1.F);
    choice.shares.push_back({static_cast<float>(threshold * view.plan.brightness), weight, weight});
    choice.off = choice.off && !fixed[r];
  }
  const auto mutations = [&](std::vector<std::size_t> of_regions) {
    const ThresholdChoice final = predict_thresholds(regions, costs, std::move(of_regions));
    return best_mutations(final.variance, final.chain_light, costs) /
           static_cast<double>(view.plan.pixels());
  };
  const std::vector<std::size_t> standby(regions.size(), view.plan.thresholds.size());
  choice.mutations = trust * mutations(chosen) + (1.0 - trust) * mutations(standby);
  return choice;
}

/// Whether chains would clearly pay for what σ gives them, where the user has not decided.
bool weights_would_pay(std::span<const RegionEstimate> regions, RenderCosts costs) {
  costs.correlation *= SelectiveHeuristics::kDoubt;
  double alone = costs.omc_only_variance;
  for (const RegionEstimate& region : regions) alone += region.variance;
  alone *= costs.seconds_per_omc_sample / costs.seconds;
  return optimal_split(regions, costs).weights.error() < SelectiveHeuristics::kClearGain * alone;
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
  const RenderCosts costs{1.0, omc_cost(view), rays_per_mutation(view), view.correlation,
                          sum_of(sample_errors(view, {"direct"}).variance)};
  RegionChoice choice;
  if (settings.map == SelectiveSettings::Map::Optimal && settings.painted.empty() &&
      !weights_would_pay(estimates, costs)) {
    for (RegionEstimate& estimate : estimates) estimate.maximum = estimate.minimum;
  }
  const TimeSplit split = optimal_split(estimates, costs);
  for (std::size_t r = 0; r < estimates.size(); ++r) {
    const auto weight = static_cast<float>(split.weights.weights[r]);
    choice.shares.push_back({0.F, weight, weight});
  }
  choice.off = !(split.weights.chain_light > 0.0);
  choice.mutations =
      split.effort.mutations / split.effort.omc_samples / static_cast<double>(view.plan.pixels());
  return choice;
}

/// What is left to ordinary Monte Carlo is made by it alone, the rest by chains alone: of each
/// pixel one of both (Frolov; docs/methods/selective.md).
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
  if (!view.plan.selective) return choose_thresholds(view);
  const SelectiveSettings& settings = *view.plan.selective;
  const bool by_thresholds = view.plan.chooses_thresholds();
  RegionChoice choice = by_thresholds ? choose_thresholds(view) : choose_weights(view);
  if (!by_thresholds) {
    const auto lowest = static_cast<float>(view.plan.lowest_threshold());
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
