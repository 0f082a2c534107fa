#pragma once
#include "mcmc/path_space/growing_path.h"
#include "mcmc/path_space/path_mutation.h"
#include "mcmc/path_space/perturbation_law.h"
#include "path/manifold_walk.h"

namespace ajar {

/// Moves the place on the film by a little and follows specular events to the first other vertex,
/// as a lens perturbation does; the specular chain from there on follows by a manifold walk to the
/// vertex after it, or the light, which stays with all that is beyond: for paths
/// (L|D) S+ D S* E. Source: Jakob & Marschner 2012, "Manifold exploration", section 4.4, for a
/// chain that may be seen through another one.
class ManifoldPerturbation final : public PathMutation {
 public:
  /// `scene` and `area` must outlive it.
  ManifoldPerturbation(const Scene& scene, const RasterArea& area);

  std::string_view name() const override { return "manifold"; }
  bool suitable(const Path& path) const override { return span_of(path).has_value(); }
  std::optional<Kept> propose(const Path& x, std::uint64_t key, Path& y) override;
  double log_density(const Path& x, const Path& y, const Kept& kept) const override;
  WalkEnd walk_end() const override { return walk_end_; }
  const RayCounts& ray_counts() const override { return rays_; }

 private:
  /// The ends of the chain that walks: vertices that are not specular.
  struct Span {
    int fixed;
    int moved;
  };
  static std::optional<Span> span_of(const Path& path);
  bool look(const Path& x, int moved, const Vec2& raster, SampleSource& source);
  /// From the chain of `x` to one that leads from its fixed end to `target`, and back again.
  bool walk(const Path& x, const Span& span, const InnerVertex& target);
  bool leads_back(const Path& x, const Span& span, double uncertainty);

  const Scene& scene_;
  const RasterArea& area_;
  PerturbationLaw raster_;
  GrowingPath growing_;
  ManifoldWalk walk_;
  std::vector<InnerVertex> chain_;
  WalkEnd walk_end_ = WalkEnd::None;
  RayCounts rays_;
};

}  // namespace ajar
