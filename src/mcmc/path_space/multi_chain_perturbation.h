#pragma once
#include "mcmc/path_space/growing_path.h"
#include "mcmc/path_space/path_mutation.h"
#include "mcmc/path_space/perturbation_law.h"

namespace ajar {

/// A lens perturbation that goes on through further specular chains: where two of them meet at
/// another vertex, the direction is moved by a little, too. For paths (L|D) D S+ … D S* E with more
/// than one D before the vertex that is joined to the rest. Source: Veach 1997, section 11.4.3.3.
class MultiChainPerturbation final : public PathMutation {
 public:
  /// `scene` and `area` must outlive it.
  MultiChainPerturbation(const Scene& scene, const RasterArea& area);

  std::string_view name() const override { return "multi-chain"; }
  bool suitable(const Path& path) const override;
  std::optional<Kept> propose(const Path& x, std::uint64_t key, Path& y) override;
  double log_density(const Path& x, const Path& y, const Kept& kept) const override;
  const RayCounts& ray_counts() const override { return rays_; }

 private:
  const Scene& scene_;
  const RasterArea& area_;
  PerturbationLaw raster_;
  PerturbationLaw direction_;
  GrowingPath growing_;
  RayCounts rays_;
};

}  // namespace ajar
