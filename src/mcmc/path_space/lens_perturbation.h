#pragma once
#include "mcmc/path_space/growing_path.h"
#include "mcmc/path_space/path_mutation.h"
#include "mcmc/path_space/perturbation_law.h"

namespace ajar {

/// Moves the place on the film by a little, mostly a very little, follows the path from the camera
/// through the same specular events to its first other vertex, and joins that to the rest, which
/// stays: for paths (L|D) D S* E. Source: Veach 1997, section 11.4.3.1.
class LensPerturbation final : public PathMutation {
 public:
  /// `scene` and `area` must outlive it.
  LensPerturbation(const Scene& scene, const RasterArea& area);

  std::string_view name() const override { return "lens"; }
  bool suitable(const Path& path) const override;
  std::optional<Kept> propose(const Path& x, std::uint64_t key, Path& y) override;
  double log_density(const Path& x, const Path& y, const Kept& kept) const override;
  const RayCounts& ray_counts() const override { return rays_; }

 private:
  const Scene& scene_;
  const RasterArea& area_;
  PerturbationLaw law_;  ///< of raster positions
  GrowingPath growing_;
  RayCounts rays_;
};

}  // namespace ajar
