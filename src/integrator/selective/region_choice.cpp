#include "integrator/selective/region_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "image/pixel_at.h"
#include "integrator/division.h"
#include "integrator/montecarlo/weighted_errors.h"
#include "integrator/regions/impulse_noise.h"
#include "integrator/regions/region_map.h"
#include "integrator/selective/heuristics.h"
#include "integrator/selective/optimal_thresholds.h"

namespace ajar {

namespace {

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

double omc_cost(const PilotView& view) {
  return view.rays * static_cast<double>(view.prepared.pixels());
}

/// Thresholds to choose from, and that of chains that make fireflies only.
std::vector<double> all_thresholds(const SelectiveConfig& config) {
  std::vector<double> thresholds = config.thresholds;
  thresholds.push_back(config.fireflies_threshold);
  return thresholds;
}

/// A path of the pilot, in the units of the pixels' errors.
struct DividedPath {
  std::uint64_t sample;   ///< camera sample that found it
  std::size_t replicate;  ///< among those that are seen
  std::size_t pixel;
  float strength;
  float light;     ///< luminance · importance in a picture of its replicate
  float roulette;  ///< fraction of its square that is due to Russian roulette
};

/// Selection of the pilot's paths.
struct PathsSeen {
  double most;             ///< for no more than so many times the brightness of the picture
  bool without_brightest;  ///< camera sample
};

/// Leaves out all paths of the sample that brings most. They are in the order of samples.
void erase_brightest(std::vector<DividedPath>& paths) {
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

std::vector<DividedPath> shared_paths(const PilotView& view, const PathsSeen& seen) {
  const auto most = static_cast<float>(seen.most * view.prepared.brightness);
  const auto scale =
      static_cast<float>(static_cast<double>(view.replicates.size()) / seen_samples(view));
  std::vector<DividedPath> paths;
  for (const PilotPath& found : view.found) {
    const auto place = std::find(view.replicates.begin(), view.replicates.end(), found.replicate);
    if (place == view.replicates.end()) continue;
    paths.push_back({found.sample, static_cast<std::size_t>(place - view.replicates.begin()),
                     pixel_at(view.prepared.config.settings.crop, found.raster), found.strength,
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
  std::vector<ThresholdEstimate> regions(view.regions().count(),
                                         {std::vector<double>(count), std::vector<double>(count)});
  const std::vector<std::vector<float>> weak =
      weighted_light(seen_pictures(view, {"direct", kWeakLayer}),
                     view.prepared.config.settings.crop, view.prepared.view.importance);
  const std::vector<DividedPath> paths = shared_paths(view, seen);
  const auto lowest = static_cast<float>(view.prepared.lowest_threshold());
  // Fireflies that no threshold helps against, of direct light, say, must decide nothing.
  const std::vector<double> least = trimmed(variance_of_mean(weak));
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::vector<float>> light = weak;
    std::vector<double> by_roulette(light.front().size());
    for (const DividedPath& path : paths) {
      const float above =
          i < thresholds.size()
              ? Division::chain_fraction(
                    path.strength, static_cast<float>(thresholds[i] * view.prepared.brightness))
              : 0.F;
      const float more = path.light * (Division::chain_fraction(path.strength, lowest) - above);
      light[path.replicate][path.pixel] += more;
      by_roulette[path.pixel] += static_cast<double>(more * more * path.roulette);
      regions[view.regions().labels[path.pixel]].light[i] +=
          static_cast<double>(std::abs(path.light) * above) /
          static_cast<double>(view.replicates.size());
    }
    const std::vector<double> variance = variance_of_mean(light);
    const auto pictures = static_cast<double>(light.size());
    for (std::size_t p = 0; p < variance.size(); ++p) {
      if (least[p] == 0.0) continue;
      regions[view.regions().labels[p]].variance[i] +=
          (variance[p] - by_roulette[p] / (pictures * pictures)) * seen_samples(view);
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

/// Estimates of what can be chosen: all but the last, by which chains would make nothing.
std::vector<ThresholdEstimate> with_chains(std::vector<ThresholdEstimate> regions) {
  for (ThresholdEstimate& region : regions) {
    region.variance.pop_back();
    region.light.pop_back();
  }
  return regions;
}

/// Predicted error with chains over that without, if they are as much worse as one may doubt.
double gain_of_chains(const PilotView& view, const std::vector<double>& thresholds,
                      ThresholdCosts costs, const PathsSeen& seen) {
  costs.correlation *= SelectiveHeuristics::kCostFactor;
  const std::vector<ThresholdEstimate> regions = estimate_thresholds(view, thresholds, seen);
  const ThresholdChoice without = predict_thresholds(
      regions, costs, std::vector<std::size_t>(regions.size(), thresholds.size()));
  return optimal_thresholds(with_chains(regions), costs).error / without.error;
}

/// Fraction from 0 (fireflies only) to 1 of what chains are to do. It is a matter of degree: the
/// halves of the replicates decide each for itself, and if one did with chains what the other does
/// without, the picture would have the noise of the one at the cost of the other.
double trust_in(double gain) { return std::max(0.0, 1.0 - gain / SelectiveHeuristics::kClearGain); }

}  // namespace

Plane pilot_noise(const PilotView& view) {
  return impulse_noise(view.regions().size,
                       replicate_mean(seen_pictures(view, {"indirect", kWeakLayer})),
                       RegionMapSettings{}.window);
}

RegionChoice choose_regions(const PilotView& view) {
  const SelectiveConfig& config = view.prepared.config;
  const std::vector<double> thresholds = all_thresholds(config);
  const std::vector<ThresholdEstimate> regions =
      estimate_thresholds(view, thresholds, {SelectiveHeuristics::kDisplayWhite, false});
  const ThresholdCosts costs{omc_cost(view), SelectiveHeuristics::kRaysPerMutation,
                             view.correlation, 0.0};
  const ThresholdChoice best = optimal_thresholds(with_chains(regions), costs);
  RegionChoice choice;
  double trust = 1.0;
  // Where the pilot has found nothing for them, they cost nothing, and stay ready.
  if (best.chain_light > 0.0) {
    // No single sample is evidence.
    choice.expected_error =
        gain_of_chains(view, thresholds, costs, {SelectiveHeuristics::kDisplayWhite, true});
    trust = trust_in(choice.expected_error);
    choice.hoped_error = choice.expected_error;
    if (trust == 0.0) {
      choice.hoped_error = std::min(
          choice.expected_error,
          gain_of_chains(view, thresholds, costs, {SelectiveHeuristics::kFireflyClamp, false}));
    }
    choice.fireflies_only = *choice.hoped_error >= SelectiveHeuristics::kClearGain;
  }
  std::vector<std::size_t> chosen = best.chosen;
  const auto fixed = config.regions.fixed_weights(view.regions(), config.scene, 0.F);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (fixed[r]) chosen[r] = 0;
    const double threshold = fixed[r] ? thresholds[chosen[r]]
                                      : std::pow(thresholds[chosen[r]], trust) *
                                            std::pow(thresholds.back(), 1.0 - trust);
    const float weight = fixed[r].value_or(1.F);
    choice.regions.push_back(
        {static_cast<float>(threshold * view.prepared.brightness), weight, weight});
    choice.fireflies_only = choice.fireflies_only && !fixed[r];
  }
  return choice;
}

RegionChoice without_chains(RegionChoice choice, std::size_t regions) {
  PixelDivision nothing = choice.regions.front();
  nothing.target_scale = 0.F;
  nothing.deposit_scale = 0.F;
  choice.regions.assign(regions, nothing);
  return choice;
}

Surfaces one_region(const Box2i& crop) {
  const Vec2i size = crop.size() + Vec2i(1, 1);
  Surfaces surfaces{.regions = {}, .edges = Plane(size)};
  const auto pixels = surfaces.edges.values.size();
  surfaces.regions = {
      size, std::vector<std::uint32_t>(pixels), {{}}, {static_cast<std::uint32_t>(pixels)}};
  return surfaces;
}

}  // namespace ajar
