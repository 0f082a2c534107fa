#pragma once
#include "mcmc/path_space/growing_path.h"
#include "mcmc/path_space/path_mutation.h"
#include "mcmc/path_space/perturbation_law.h"
#include "path/manifold_walk.h"

namespace ajar {

/// Moves the place on the film by a little and follows how x scatters to a vertex that moves; the
/// chain from there on follows by a manifold walk to a vertex, or the light, which stays with all
/// that is beyond. Vertices on the way hold their constraints: specular ones their events, rough
/// ones their offset normals, which are moved by a little. Source: Jakob & Marschner 2012,
/// "Manifold exploration", section 4.4, for a chain that may be seen through another one.
class ConstraintPerturbation : public PathMutation {
 public:
  /// `scene` and `area` must outlive it.
  ConstraintPerturbation(const Scene& scene, const RasterArea& area);

  bool suitable(const Path& path) const override;
  std::optional<Kept> propose(const Path& x, std::uint64_t key, Path& y) override;
  double log_density(const Path& x, const Path& y, const Kept& kept) const override;
  WalkEnd walk_end() const override { return walk_end_; }
  const RayCounts& ray_counts() const override { return rays_; }

 protected:
  /// The ends of the chain that walks, between which there may be nothing. Between the camera and
  /// `moved`, too, all vertices hold constraints.
  struct Span {
    int fixed;
    int moved;
  };

 private:
  /// Empty if the path is not of the kind. Vertices need not be able to hold constraints.
  virtual std::optional<Span> span_of(const Path& path) const = 0;

  /// By vertex of a path; those that are not rough have none.
  using Offsets = std::vector<OffsetNormal>;
  /// The offset normals of `x` around the vertex that moves, and others near them. False if there
  /// are no such facets.
  bool move_offsets(const Path& x, const Span& span, SampleSource& source);
  std::optional<OffsetNormal> offset_of(const Path& path, int vertex) const;
  /// Perturbation of a vertex's offset normal; empty if it cannot be moved.
  std::optional<PerturbationLaw> offset_law(const Path& path, int vertex) const;
  double log_offset_density(const Path& x, const Path& y, int vertex) const;
  /// Log density of the end of a proposal's walk.
  double log_walk_density(const Path& path, const Span& span) const;
  bool look(const Path& x, int moved, const Vec2& raster, SampleSource& source);
  /// From the chain of `x` to one that leads from its fixed end to `target`, and back again.
  bool walk(const Path& x, const Span& span, const InnerVertex& target);
  /// True if the reverse walk, which arrived, came to the chain of `x` and to no other between the
  /// same ends. Tests both chains, so that a walk from the other one gives the same answer.
  /// `uncertainty`: of both.
  bool leads_back(const Path& x, const Span& span, const InnerVertex& target, double uncertainty);

  const Scene& scene_;
  const RasterArea& area_;
  PerturbationLaw raster_;
  GrowingPath growing_;
  ManifoldWalk walk_;
  SpecularChain old_chain_;
  Offsets old_offsets_;
  Offsets new_offsets_;
  std::vector<InnerVertex> chain_;
  WalkEnd walk_end_ = WalkEnd::None;
  RayCounts rays_;
};

}  // namespace ajar
