#pragma once
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "integrator/metropolis/heuristics.h"
#include "integrator/metropolis/path_group.h"
#include "integrator/metropolis/path_share.h"
#include "integrator/metropolis/sample_of_chains.h"
#include "mcmc/path_space/manifold_seeds.h"
#include "path/recorder.h"

namespace ajar {

/// What chains of explicit paths start from. I of a sample is what all connections of two subpaths
/// bring, MIS weights included, and now and then what manifold connections bring of paths that
/// light hit by chance finds alone: these two share such paths by `ManifoldSeeds::hit_share`. So
/// samples that are chosen in proportion to I, and one of their paths in proportion to what it
/// brings, give paths in proportion to their light. A target that never splats.
class PathSeeds final : public PathTarget {
 public:
  /// What is referred to must outlive it. `part`: of what techniques bring, if chains do not make
  /// all light; else null. `manifold_tries`: of manifold connections, for each sample.
  PathSeeds(const Scene& scene, const PathGroup& group, const ChainView& view,
            const ChainWeight* part = nullptr,
            double manifold_tries = MetropolisHeuristics::kManifoldTries);
  PathSeeds(const PathSeeds&) = delete;
  PathSeeds& operator=(const PathSeeds&) = delete;

  double evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) override;
  /// One of the paths of a sample, whose I is `total`; `u` in [0, 1) is uniform. Empty if none of
  /// them can be a state of a chain (edges that rounding interrupts when traced again).
  std::optional<Path> choose(SampleSource& numbers, double total, double u);

  /// Whether chains of a group make what manifold connections find.
  static bool has_manifolds(const PathGroup& group) {
    return is_explicit(group.kind) && has_paths(group.paths, true) &&
           group.sampler.techniques.any(TechniqueClass::Implicit);
  }
  /// Whether those of any of them do.
  static bool any_has_manifolds(std::span<const PathGroup> groups) {
    return std::any_of(groups.begin(), groups.end(), has_manifolds);
  }
  struct Joined {
    Path path;
    double brings;
  };
  /// What a try of manifold connections brings, which the group must have, by the randomness that
  /// `key` names; in the mean, what running into the light leaves of such paths.
  std::vector<Joined> join_by_manifolds(std::uint64_t key);

  const RayCounts& ray_counts() const override { return rays_; }

 private:
  /// Of the paths of a sample that it is told of, the sum of what they bring, and that path by
  /// which the sum comes to a place; the last one, should it not.
  class Lot final : public PathRecorder {
   public:
    explicit Lot(PathSeeds& seeds)
        : PathRecorder(seeds.scene_, seeds.group_.sampler), seeds_(seeds) {}
    /// A sample begins. `key` names the randomness that is left for its paths. `place`: of the
    /// sum; empty if no path is to be chosen.
    void begin_sample(const Vec2& raster, std::uint64_t key, std::optional<double> place);
    void add_path(const Path& path, double brings);
    bool chooses() const { return place_.has_value(); }
    bool has_chosen() const { return place_ && total > *place_; }
    bool reaches(const Vec2& raster) const override;

    double total = 0.0;
    std::optional<Path> chosen;

   private:
    bool wants(const Contribution& contribution) override;
    void record(const Path& path, const Contribution& contribution) override;
    double brings(const Contribution& contribution) const;

    PathSeeds& seeds_;
    std::optional<double> place_;
    std::uint64_t key_ = 0;
  };

  void sample(SampleSource& numbers, std::optional<double> place);
  void add_manifolds(std::uint64_t key);
  std::span<const ManifoldSeeds::Seed> try_manifolds(std::uint64_t key);
  void count_rays();
  /// ln f* of a path with all weights.
  double log_light(const Path& path);

  const Scene& scene_;
  const PathGroup& group_;
  const ChainView& view_;
  const ChainWeight* part_;
  double manifold_tries_;
  PathShare share_;
  PathSampler sampler_;
  PathBounds bounds_;
  ManifoldSeeds manifolds_;
  bool by_manifolds_;
  Lot lot_;
  SplatBuffer splats_;
  RayCounts rays_;
};

/// One of the paths of a sample, which is traced once more; `number`: of the chain that starts from
/// it.
std::optional<Path> choose_path(const Scene& scene, const PathGroup& group, const ChainView& view,
                                const SampleOfChains& sample, std::uint64_t number,
                                const ChainWeight* part = nullptr);

}  // namespace ajar
