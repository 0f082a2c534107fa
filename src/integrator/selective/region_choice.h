#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "image/film.h"
#include "integrator/selective/heuristics.h"
#include "integrator/selective/preparation.h"

namespace ajar {

/// A path of the pilot whose light chains may make.
struct PilotPath {
  std::uint64_t sample;  ///< as in `OutlierPath`
  Vec2 raster;
  Spectrum value;  ///< left to chains by the pilot, as it would be splatted
  float strength;  ///< g of `Division`
  float energy;    ///< luminance · importance of the whole path
  float weight;    ///< inverse survival probability; already in `value`
  std::int16_t replicate;
  std::int16_t s;  ///< vertices of the light subpath
  std::int16_t t;
  bool whole = false;  ///< chains cannot make any of it
};

/// Samples of the pilot, as some of its replicates show them.
struct PilotView {
  const SelectivePreparation& prepared;
  const Film& film;
  const Integrator& omc;  ///< integrator that rendered it
  std::uint64_t samples;  ///< per pixel, of all replicates
  double rays;            ///< per camera sample
  std::span<const PilotPath> found;
  std::vector<int> replicates;  ///< replicates in view; others are as if they were not there
  /// C: variance of a mutation over that of an independent sample.
  double correlation = SelectiveHeuristics::kCorrelation;

  const Regions& regions() const { return prepared.surfaces.regions; }
};

/// Division of the regions of a picture.
struct RegionChoice {
  std::vector<PixelDivision> regions;
  /// Predicted error with chains over that without, with 8 C and without the most favourable camera
  /// sample.
  double expected_error = 1.0;
  /// The least that luck may make of it: with that sample, and fireflies as bright as they are.
  /// Empty where the pilot has found nothing for chains, which tells nothing.
  std::optional<double> hoped_error;
  /// Chains would only cost: they have the highest threshold everywhere.
  bool fireflies_only = false;

  /// Chains might pay clearly, and more so where each region chooses.
  bool has_hope() const { return hoped_error && *hoped_error < SelectiveHeuristics::kClearGain; }
  /// Chains would not, however lucky.
  bool is_hopeless() const { return hoped_error && !has_hope(); }
};

/// Division of least predicted error (optimal_thresholds.h); the user's rules have the last word.
RegionChoice choose_regions(const PilotView& view);
/// A choice for `regions` of them, of which chains make nothing.
RegionChoice without_chains(RegionChoice choice, std::size_t regions);

/// The whole picture in one piece.
Surfaces one_region(const Box2i& crop);

/// Impulse noise of the indirect light that the replicates show.
Plane pilot_noise(const PilotView& view);

}  // namespace ajar
