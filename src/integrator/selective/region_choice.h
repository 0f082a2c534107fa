#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/film.h"
#include "image/regions.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

/// A path of the pilot with light that chains may make.
struct FoundLight {
  std::uint64_t sample;  ///< of `StrongPath`
  Vec2 raster;
  Spectrum value;  ///< what the pilot has left to chains, as it would be splatted
  float strength;  ///< g of `Division`
  float energy;    ///< luminance · importance of all that the path brings
  float weight;    ///< paths like it that were found and not kept stand behind it; `value` has it
  std::int16_t replicate;
  std::int16_t s;  ///< of its technique
  std::int16_t t;
  bool whole = false;  ///< chains cannot make any of it
};

/// What some replicates of the pilot say.
struct PilotView {
  const ChainPlan& plan;
  const Regions& regions;
  const Film& film;
  const Integrator& omc;  ///< that rendered it
  std::uint64_t samples;  ///< per pixel, of all replicates
  double rays;            ///< per camera sample
  std::span<const FoundLight> found;
  std::vector<int> replicates;  ///< that are seen; the others are as if they were not there
  /// C of optimal_weights.h: chains land in clusters.
  double correlation = SelectiveHeuristics::kCorrelation;
};

/// How the regions of a picture are divided.
struct RegionChoice {
  std::vector<PixelShare> shares;  ///< of each region
  std::vector<float> noise;        ///< of each region: ½(mean + largest) of that at or above T
  double mutations = 0.0;          ///< per camera sample, for least predicted error
  /// Predicted error with chains over that without, where the light is divided by thresholds; with
  /// C higher than it was taken to be, and without the sample that speaks for chains most.
  double expected_error = 1.0;
  /// Chains would only cost: they have the highest threshold everywhere, or nothing at all where
  /// light is not divided path by path.
  bool off = false;
};

/// Decides so that the predicted error is smallest (optimal_weights.h for regions,
/// optimal_thresholds.h where light is divided path by path), or as `SelectiveSettings` has it, if
/// there are any: by the published rule (region_map.h); rules and presets have the last word.
RegionChoice choose_regions(const PilotView& view);

/// Noise of the indirect light that the replicates show (noise.h).
Plane pilot_noise(const PilotView& view);

}  // namespace ajar
