#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "core/parameters.h"
#include "integrator/chain_family.h"
#include "integrator/light_split.h"
#include "integrator/path_target.h"
#include "mcmc/bootstrap.h"
#include "mcmc/chain_runner.h"
#include "mcmc/plane_moves.h"

namespace ajar {

/// What all chains of one kind of path share: the depth, or all depths.
struct PathGroup {
  int depth;  ///< edges; 0: all
  PathSamplerSettings sampler;
  TechniqueChoice choice;  ///< if there is one depth
  PrimaryShape shape;
};

/// What a render with chains is to do: its parameters, read and checked, and what the preparation
/// finds out before the first chain moves. Constant from then on.
struct ChainPlan {
  enum class Direct { Omc, Chain, None };

  /// Raises UsageError.
  ChainPlan(ChainKind kind, const Scene& scene, const RenderSettings& settings,
            const Parameters& parameters, std::optional<Selection> selection);

  /// A target of one thread; the plan must outlive it.
  std::unique_ptr<PathTarget> make_target(const PathGroup& group) const;
  /// Of the crop.
  std::uint64_t pixels() const;
  /// Depths that ordinary Monte Carlo renders; empty (min > max) if there are none.
  std::pair<int, int> omc_depths() const;
  /// Ordinary Monte Carlo with the chains' techniques over some depths. With `split`, it leaves the
  /// chains their share. `split` must outlive it.
  std::unique_ptr<Integrator> make_omc(const RenderSettings& settings, std::pair<int, int> depths,
                                       const LightSplit* split) const;

  ChainKind kind;
  std::optional<Selection> selection;
  const Scene& scene;
  RenderSettings settings;
  Parameters parameters;
  TechniqueSet techniques;
  Direct direct;
  bool mis_large_steps;
  /// Where the light of long paths is divided, relative to the brightness of its pixel; empty if
  /// chains make all of it.
  std::optional<double> split_at;
  /// Of a pass's samples per pixel: how many camera samples of ordinary Monte Carlo each stands
  /// for, and how many mutations.
  double omc_samples;
  double mutations = 1.0;
  /// Of the pilot: mean luminance · importance of its pixels.
  double brightness = 0.0;
  /// True if the survey found so little light for chains that ordinary Monte Carlo makes it all.
  bool without_chains = false;
  std::uint64_t bootstrap;      ///< samples, over all depths and replicates
  std::uint64_t wanted_chains;  ///< 0: as many as suit the picture
  SeedFilter seed_filter;
  double seed_spread;  ///< standard deviations above which a seed is an outlier
  ChainSettings chain_settings;
  std::unique_ptr<Mutation> mutation;
  PlaneRule plane;
  ChainView view;
  std::vector<PathGroup> groups;
  std::optional<LightSplit> split;  ///< found by the pilot

 private:
  void make_groups();
  void read_importance();
  void read_plane();
};

}  // namespace ajar
