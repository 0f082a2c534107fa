#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/parameters.h"
#include "integrator/integrator.h"
#include "integrator/metropolis/path_target.h"
#include "mcmc/path_space/path_bounds.h"
#include "mcmc/path_space/specular_photons.h"
#include "mcmc/primary/chain_numbers.h"

namespace ajar {

/// Space of a chain's states.
enum class ChainSpace {
  Pssmlt,  ///< `pssmlt`: a camera and a light subpath with all their connections
  Mmlt,    ///< `mmlt`: one path of one depth and technique
  Paths,   ///< `mlt`: one path of any depth, and of no technique
  Erpt,    ///< `erpt`: the same, in chains that end before others begin
  Auto     ///< Mmlt, and Paths for `PathClass::UnidirectionalOnly`
};
constexpr bool is_explicit(ChainSpace kind) {
  return kind == ChainSpace::Paths || kind == ChainSpace::Erpt;
}
/// True if there are chains of one path of one depth and technique.
constexpr bool has_one_path(ChainSpace kind) {
  return kind == ChainSpace::Mmlt || kind == ChainSpace::Auto;
}
/// True if there are chains of explicit paths.
constexpr bool has_explicit(ChainSpace kind) {
  return is_explicit(kind) || kind == ChainSpace::Auto;
}

/// Common data of all chains of one kind of path: the depth, or all depths.
struct PathGroup {
  ChainSpace kind;
  PathClass paths;
  int depth;  ///< edges; 0: all
  PathSamplerSettings sampler;
  TechniqueChoice choice;  ///< if there is one depth
  PrimaryShape shape;
  /// Photons that guide manifold connections of explicit paths.
  std::shared_ptr<const SpecularPhotons> photons;
};

/// Groups for the paths of a sampler, which has everything but the start of Russian roulette:
/// `roulette_start` unless it is OnePath; paths of a given depth gain nothing from ending early.
/// Explicit paths start from connections of two subpaths. Of ByPath, the last group is of explicit
/// paths, if the sampler hits lights at all. Empty if there are no such paths. `scene` must outlive
/// them.
std::vector<PathGroup> make_path_groups(const Scene& scene, ChainSpace kind,
                                        const PathSamplerSettings& sampler, int roulette_start);
/// The share of all bootstrap samples that a group gets: long paths carry little light and cost
/// much.
double bootstrap_share(std::span<const PathGroup> groups, std::size_t group);

/// View of a scene's film, as far as its filter reaches beyond the crop.
ChainView view_of(const Scene& scene, const RenderSettings& settings);

/// Limits of the explicit paths that chains of the group may make.
inline PathBounds bounds_of(const PathGroup& group, const ChainView& view) {
  return {view, group.sampler.min_depth, group.sampler.max_depth, group.sampler.counted};
}

/// Everything that chains of one group need to know of what they sample.
struct ChainProblem {
  const Scene& scene;
  const PathGroup& group;
  const ChainView& view;
  const ChainWeight* part = nullptr;  ///< weight of chains in the light; null: 1
};

/// A target of one thread; of explicit paths, connections of two subpaths. What is referred to must
/// outlive it; `part`, over whose share of the light it is, may be null.
std::unique_ptr<PathTarget> make_path_target(const Scene& scene, const PathGroup& group,
                                             const ChainView& view,
                                             const ChainWeight* part = nullptr);

inline std::unique_ptr<PathTarget> make_path_target(const ChainProblem& problem) {
  return make_path_target(problem.scene, problem.group, problem.view, problem.part);
}

/// A target of bootstraps: for explicit paths, that of their seeds (`PathSeeds`). It never
/// splats.
std::unique_ptr<PathTarget> make_seed_target(const Scene& scene, const PathGroup& group,
                                             const ChainView& view,
                                             const ChainWeight* part = nullptr);
inline std::unique_ptr<PathTarget> make_seed_target(const ChainProblem& problem) {
  return make_seed_target(problem.scene, problem.group, problem.view, problem.part);
}

/// The parameter of that name. Raises UsageError for techniques that are tried several times:
/// chains have no numbers for further tries, and would gain nothing from fewer.
TechniqueSet techniques_of_chains(const Parameters& parameters);

}  // namespace ajar
