#pragma once
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "integrator/metropolis/divided_path_weight.h"
#include "integrator/metropolis/heuristics.h"
#include "integrator/metropolis/path_group.h"
#include "integrator/metropolis/sample_of_chains.h"
#include "mcmc/path_space/manifold_seeds.h"
#include "path/recorder.h"

namespace ajar {

/// Seeds of chains of explicit paths. I of a sample is the contribution of all connections of two
/// subpaths, MIS weights included, and at times that of manifold connections to paths that only
/// unidirectional hits sample: these two share such paths by `ManifoldSeeds::hit_share`. So samples
/// that are chosen in proportion to I, and one of their paths in proportion to its contribution,
/// give paths in proportion to their light. Never splats.
class PathSeeds final : public PathTarget {
 public:
  /// All arguments must outlive it. `part`: of what techniques bring, if chains do not make
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

  /// True if chains of a group contain the paths of manifold connections.
  static bool has_manifolds(const PathGroup& group) {
    return is_explicit(group.kind) && has_paths(group.paths, true) &&
           group.sampler.techniques.any(TechniqueClass::Implicit);
  }
  /// True if those of any group do.
  static bool any_has_manifolds(std::span<const PathGroup> groups) {
    return std::any_of(groups.begin(), groups.end(), has_manifolds);
  }
  struct Joined {
    Path path;
    double brings;
  };
  /// Contribution of a try of manifold connections, which the group must have, by the randomness
  /// that `key` names; in the mean, the part of such paths that unidirectional hits leave.
  std::vector<Joined> join_by_manifolds(std::uint64_t key);

  const RayCounts& ray_counts() const override { return rays_; }

 private:
  /// Sums path contributions of a sample; picks the path at which the sum passes a place, or the
  /// last one.
  class PathPicker final : public PathRecorder {
   public:
    explicit PathPicker(PathSeeds& seeds)
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
  DividedPathWeight share_;
  PathSampler sampler_;
  PathBounds bounds_;
  ManifoldSeeds manifolds_;
  bool by_manifolds_;
  PathPicker picker_;
  SplatBuffer splats_;
  RayCounts rays_;
};

/// One of the paths of a sample, which is traced once more; `number`: of the chain that starts from
/// it.
std::optional<Path> choose_path(const Scene& scene, const PathGroup& group, const ChainView& view,
                                const SampleOfChains& sample, std::uint64_t number,
                                const ChainWeight* part = nullptr);

}  // namespace ajar
