#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "integrator/division.h"
#include "integrator/metropolis/path_group.h"
#include "integrator/montecarlo/efficient_roulette.h"
#include "integrator/outlier_paths.h"
#include "integrator/regions/surface_pilot.h"
#include "integrator/selective/config.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

/// Paths of ordinary Monte Carlo and of chains: the same techniques, each as often, since that is
/// part of what a path brings.
struct ChosenTechniques {
  PathFamilyDefaults omc;
  std::vector<PathGroup> groups;  ///< groups of chains; empty if there are no long paths
  /// Paths of one depth as ordinary Monte Carlo finds them, where groups hold several depths.
  std::vector<PathGroup> depth_groups;
};
ChosenTechniques choose_techniques(const SelectiveConfig& config, const PathFamilyDefaults& omc);

/// Configuration of a render, and what the stages of its preparation have found. `selective.cpp`
/// alone writes it, one member after the other; stages read those before theirs.
struct SelectivePreparation {
  explicit SelectivePreparation(SelectiveConfig the_config);
  SelectivePreparation(const SelectivePreparation&) = delete;
  SelectivePreparation& operator=(const SelectivePreparation&) = delete;

  const SelectiveConfig config;

  /// Cells end paths, rather than throughput. Connections between subpaths judge their worth by
  /// themselves, and want many samples more than long subpaths.
  bool has_efficient_roulette() const;

  // ---- BrightnessPilot
  double brightness = 0.0;  ///< mean luminance · importance of the pixels; 0: no light was found
  ChainView view;           ///< with the importance of places on the film; until then, that given
  std::optional<PictureScale> scale;  ///< scale of the picture; measured anew unless it is known

  /// Roulette of ordinary Monte Carlo; null if it is the usual.
  std::unique_ptr<EfficientRoulette> roulette;

  // ---- TechniquePilot; until then, of the configuration
  ChosenTechniques techniques;

  // ---- SurfacePilot
  Surfaces surfaces;

  // ---- DivisionPilot
  std::optional<Divisions> divisions;  ///< until then, at the lowest threshold everywhere
  double mutations = 1.0;         ///< per pixel and sample, at first; 0: ordinary Monte Carlo alone
  bool fireflies_only = false;    ///< nothing is so hard that chains would pay
  std::uint64_t pilot_kept = 0;   ///< camera samples per pixel that stay in the picture
  std::uint64_t pilot_tried = 0;  ///< camera samples that chains might start from

  /// Reason why the preparation was cut short; ordinary Monte Carlo alone renders then.
  std::optional<PreparationCut> preparation_cut;

  const Scene& scene() const { return config.scene; }
  std::uint64_t pixels() const { return config.pixels(); }
  const std::vector<PathGroup>& groups() const { return techniques.groups; }
  /// T of the pixel where it is lowest, in the units of `PixelDivision`.
  double lowest_threshold() const { return config.thresholds.front() * brightness; }
  /// The division of a replicate; null if there is none.
  const ChainWeight* part_of(int replicate) const {
    return divisions ? &divisions->of(replicate) : nullptr;
  }
  /// The group of paths of this depth, technique by technique.
  const PathGroup& group_of(int depth) const;
  /// The group whose chains make a path.
  const PathGroup& group_of(const OutlierPath& found) const;
  ChainProblem problem(const PathGroup& group, int replicate) const {
    return {config.scene, group, view, part_of(replicate)};
  }
  /// Moves of primary numbers: where chains make nearly all light, steps on the raster pay more.
  PrimarySettings moves_of(int replicate) const;
  std::size_t chains_per_replicate() const;

  /// Depths that ordinary Monte Carlo renders.
  std::pair<int, int> omc_depths() const {
    return {config.settings.min_depth, config.settings.max_depth};
  }
  /// Parameters of ordinary Monte Carlo.
  static Parameters omc_parameters(const PathFamilyDefaults& omc) {
    return {path_family_parameters(omc), {}};
  }
  /// Ordinary Monte Carlo with techniques `omc`, as `make_path_integrator` has it.
  std::unique_ptr<Integrator> make_omc(const PathFamilyDefaults& omc, RenderSettings settings,
                                       PathIntegratorContext context = {}) const;
};

/// Cost of a camera sample with all its light subpaths, relative to one with a single one.
double effort_of(const PathFamilyDefaults& omc);

/// Bounds on mutations per pixel and sample: neither estimator starves.
constexpr double kMostMutations = 1.0 / SelectiveHeuristics::kFewestMutations;
inline double clamp_mutations(double mutations) {
  return std::clamp(mutations, SelectiveHeuristics::kFewestMutations, kMostMutations);
}

}  // namespace ajar
