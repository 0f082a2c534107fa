#pragma once
#include <optional>

#include "integrator/metropolis/path_group.h"
#include "integrator/metropolis/path_share.h"
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
  /// all light; else null.
  PathSeeds(const Scene& scene, const PathGroup& group, const ChainView& view,
            const PathPart* part = nullptr);

  double evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) override;
  /// One of the paths of a sample; `u` in [0, 1) is uniform. Empty if none of them can be a state
  /// of a chain (edges that rounding interrupts when traced again).
  std::optional<Path> choose(SampleSource& numbers, double u);

  const RayCounts& ray_counts() const override { return rays_; }

 private:
  /// Of the paths of a sample that it is told of, the sum of what they bring, and one of them.
  class Lot final : public PathRecorder {
   public:
    explicit Lot(PathSeeds& seeds)
        : PathRecorder(seeds.scene_, seeds.group_.sampler), seeds_(seeds) {}
    /// A sample begins. `u`: by which a path is chosen; empty if none is to be.
    void begin_sample(const Vec2& raster, std::optional<double> u);
    void add_path(const Path& path, double brings);
    bool reaches(const Vec2& raster) const override;

    double total = 0.0;
    std::optional<Path> chosen;

   private:
    bool wants(const Contribution& contribution) override;
    void record(const Path& path, const Contribution& contribution) override;
    double brings(const Contribution& contribution) const;

    PathSeeds& seeds_;
    std::optional<double> u_;
    SplatBuffer splats_;
  };

  void sample(SampleSource& numbers, std::optional<double> u);
  void join_by_manifolds(std::uint64_t key);
  /// ln f* of a path with all weights.
  double log_light(const Path& path);

  const Scene& scene_;
  const PathGroup& group_;
  const ChainView& view_;
  const PathPart* part_;
  PathShare share_;
  PathSampler sampler_;
  PathBounds bounds_;
  ManifoldSeeds manifolds_;
  bool by_manifolds_;
  Lot lot_;
  SplatBuffer splats_;
  RayCounts rays_;
};

/// Sample `index` of a bootstrap with this seed once more, for one of its paths.
std::optional<Path> choose_path(const Scene& scene, const PathGroup& group, const ChainView& view,
                                std::uint64_t seed, std::uint64_t index, double u,
                                const PathPart* part = nullptr);

}  // namespace ajar
