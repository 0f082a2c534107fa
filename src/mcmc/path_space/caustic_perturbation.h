#pragma once
#include "mcmc/path_space/growing_path.h"
#include "mcmc/path_space/path_mutation.h"
#include "mcmc/path_space/perturbation_law.h"

namespace ajar {

/// Moves by a little the direction in which a light, or the last vertex before a specular chain,
/// sends light (of a light at infinity: the place where the ray passes), follows the same specular
/// events to the next other vertex, and joins that to the lens: for paths (L|D) S* D E. The size is
/// such that the picture of that vertex moves about as far as by a lens perturbation. Source: Veach
/// 1997, section 11.4.3.2.
class CausticPerturbation final : public PathMutation {
 public:
  /// `scene` and `area` must outlive it.
  CausticPerturbation(const Scene& scene, const RasterArea& area);

  std::string_view name() const override { return "caustic"; }
  bool suitable(const Path& path) const override;
  std::optional<Kept> propose(const Path& x, std::uint64_t key, Path& y) override;
  double log_density(const Path& x, const Path& y, const Kept& kept) const override;
  const RayCounts& ray_counts() const override { return rays_; }

 private:
  /// Perturbation of the direction, or place, in which vertex `from` of the path sends light.
  PerturbationLaw law(const Path& path, int from) const;
  bool set_off(const Path& x, int from, const Vec2& u);

  const Scene& scene_;
  PerturbationLaw raster_;
  GrowingPath growing_;
  RayCounts rays_;
};

}  // namespace ajar
