#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/parameters.h"
#include "integrator/division.h"
#include "integrator/metropolis/member_chain.h"
#include "integrator/metropolis/path_group.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/selective/chain_family.h"
#include "integrator/selective/heuristics.h"
#include "integrator/selective/pilot_use.h"
#include "integrator/selective/selective_moves.h"
#include "integrator/selective/selective_settings.h"
#include "integrator/strong_paths.h"
#include "mcmc/bootstrap.h"
#include "mcmc/primary/primary_runner.h"

namespace ajar {

/// What a render with chains is to do: its parameters, read and checked, and what the preparation
/// finds out before the first chain moves. Constant from then on.
struct ChainPlan {
  enum class Direct { Omc, Chain, None };

  /// Raises UsageError.
  ChainPlan(ChainKind kind, const Scene& scene, const RenderSettings& settings,
            const Parameters& parameters, std::optional<SelectiveSettings> selective = {});

  /// A target of one thread, for chains of a replicate; the plan must outlive it.
  std::unique_ptr<PathTarget> make_target(const PathGroup& group, int replicate) const;
  /// The same for bootstraps.
  std::unique_ptr<PathTarget> make_seed_target(const PathGroup& group, int replicate) const;
  /// For paths of one depth as ordinary Monte Carlo finds them, technique by technique.
  const PathGroup& group_of(int depth) const;
  /// The division of a replicate; null if there is none.
  const PathPart* part_of(int replicate) const {
    return divisions ? &divisions->of(replicate) : nullptr;
  }
  /// The group whose chains make what was found.
  const PathGroup& group_of(const StrongPath& found) const;
  /// Of the crop.
  std::uint64_t pixels() const;
  /// In the units of `PixelShare`; 0 if light is not divided path by path.
  double lowest_threshold() const {
    return thresholds.empty() ? 0.0 : thresholds.front() * brightness;
  }
  /// Whether chains start from what ordinary Monte Carlo finds: it divides light path by path and
  /// makes the same paths.
  bool has_recruits() const { return !thresholds.empty() && kind != ChainKind::WholePath; }
  /// Whether a pilot decides between thresholds; else, if at all, it decides by regions alone.
  bool chooses_thresholds() const {
    return thresholds.size() > 1 &&
           (!selective || selective->map == SelectiveSettings::Map::Optimal);
  }
  /// Where light is divided path by path, both halves have the same techniques, each as often: that
  /// is part of what a path brings.
  void set_omc(const PathFamilyDefaults& choice);
  /// Of a camera sample with so many light subpaths, relative to one with a single one.
  static double effort_with(double light_paths_per_pixel) {
    constexpr double kOfLight = SelectiveHeuristics::kEffortOfLight;
    return (1.0 - kOfLight) + kOfLight * light_paths_per_pixel;
  }
  /// Does without chains, and without what a preparation would find out. `kept`: camera samples
  /// per pixel that a pilot has rendered.
  void leave_to_omc(Shortage shortage, std::uint64_t kept);
  /// How its chains move: where they make nearly all light, steps on the raster pay more.
  PrimarySettings chain_settings_of(int replicate) const;
  static double clamp_mutations(double mutations) {
    return std::clamp(mutations, SelectiveHeuristics::kFewestMutations,
                      SelectiveHeuristics::kMostMutations);
  }
  /// How many chains a replicate should have.
  std::size_t chains_per_replicate() const;
  /// Depths that ordinary Monte Carlo renders; empty (min > max) if there are none.
  std::pair<int, int> omc_depths() const;
  /// As the render has it: without the layers that are made of chains.
  RenderSettings omc_settings() const;
  /// Its other parameters.
  Parameters omc_parameters() const;
  /// Ordinary Monte Carlo over some depths, as `make_path_integrator` has it.
  std::unique_ptr<Integrator> make_omc(const RenderSettings& settings, std::pair<int, int> depths,
                                       PathIntegratorContext context = {}) const;

  ChainKind kind;
  const Scene& scene;
  RenderSettings settings;
  Parameters parameters;
  TechniqueSet techniques;
  Direct direct;
  PilotUse pilot_use = PilotUse::Keep;
  std::optional<Shortage> unprepared;  ///< for want of which ordinary Monte Carlo alone renders
  bool unlit = false;    ///< the preparation found nothing to start chains of `selective` from
  bool standby = false;  ///< nothing is so hard that chains would pay
  /// Whether the render shares its effort anew as it goes on: a sample then has as many mutations
  /// as its halves' errors deserve.
  bool shares_effort = false;
  /// Whether a pilot decides what techniques there are, and how many light subpaths.
  bool chooses_omc = false;
  /// Where the light of long paths may be divided path by path, relative to the brightness of its
  /// pixel, from the lowest on; empty if it is not. The pilot chooses.
  std::vector<double> thresholds;
  /// The same for chains that stand by.
  double standby_threshold = 0.0;
  /// If regions of the picture are divided, too.
  std::optional<SelectiveSettings> selective;
  std::uint64_t pilot_samples = 0;  ///< per pixel, at least
  /// Camera samples of ordinary Monte Carlo that a sample of the render has per pixel.
  double omc_samples;
  /// Mutations per pixel that a sample of the render has, at first if the effort is shared; 0:
  /// ordinary Monte Carlo alone renders.
  double mutations = 1.0;
  std::uint64_t pilot_kept = 0;  ///< camera samples per pixel that the preparation has rendered
  /// Of the pilot: mean luminance · importance of its pixels.
  double brightness = 0.0;
  bool is_black = false;  ///< the pilot has found no light
  /// What that pilot has seen, for users to look at: RGB, row by row of the crop; empty once it was
  /// taken.
  std::vector<float> first_look;
  /// Samples from which chains are seeded: camera samples where the light is divided, else paths
  /// over all depths and replicates.
  std::uint64_t bootstrap;
  std::uint64_t scouted = 0;    ///< camera samples that were
  std::uint64_t wanted_chains;  ///< 0: as many as suit the picture
  SeedRule seed_rule;
  SelectiveMoves moves;
  ChainView view;
  std::vector<PathGroup> groups;
  std::vector<double> path_mutations;  ///< weights, of chains of explicit paths
  PathFamilyDefaults omc;              ///< of ordinary Monte Carlo
  std::optional<RayPrice> ray_price;   ///< likewise, as a pilot has found it
  std::optional<Divisions> divisions;  ///< found by the pilot

 private:
  std::vector<PathGroup> depth_groups_;  ///< where those of the chains hold several depths
  /// Of the picture, from when ordinary Monte Carlo was made first, and of paths of which depths.
  mutable std::optional<PictureScale> scale_;
  mutable std::pair<int, int> scale_depths_;

  void make_groups();
  void read_split();
  void read_omc();
  void read_pilot();
  void read_importance();
};

}  // namespace ajar
