#pragma once
#include "mcmc/path_space/growing_path.h"
#include "mcmc/path_space/path_mutation.h"

namespace ajar {

/// Replaces the path's end at the camera, with its first vertex that is not specular, by a fresh
/// one, which may have other specular events and others in number, and joins it to the rest: for
/// paths (L|D) D S* E. Source: Veach 1997, section 11.4.4.
class LensSubpathMutation final : public PathMutation {
 public:
  /// `scene` and `area` must outlive it. Paths have `min_depth` to `max_depth` edges.
  LensSubpathMutation(const Scene& scene, const RasterArea& area, int min_depth, int max_depth);

  std::string_view name() const override { return "lens-subpath"; }
  bool suitable(const Path& path) const override;
  std::optional<Kept> propose(const Path& x, std::uint64_t key, Path& y) override;
  double log_density(const Path& x, const Path& y, const Kept& kept) const override;
  const RayCounts& ray_counts() const override { return rays_; }

 private:
  const Scene& scene_;
  const RasterArea& area_;
  int min_depth_;
  int max_depth_;
  GrowingPath growing_;
  RayCounts rays_;
};

}  // namespace ajar
