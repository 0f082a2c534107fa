#pragma once
#include "mcmc/path_space/growing_path.h"
#include "mcmc/path_space/path_mutation.h"
#include "mcmc/path_space/perturbation_law.h"

namespace ajar {

/// Common base of perturbations that begin at the camera: the place on the film moves by a little,
/// mostly a very little; specular events stay; where the path scatters otherwise on its way, the
/// direction is turned by a little, too. The last new vertex is joined to the rest of the path,
/// which stays, or is the light that the path runs into.
class CameraPerturbation : public PathMutation {
 public:
  /// `scene` and `area` must outlive it.
  CameraPerturbation(const Scene& scene, const RasterArea& area);

  bool suitable(const Path& path) const final { return end_of(path).has_value(); }
  std::optional<Kept> propose(const Path& x, std::uint64_t key, Path& y) final;
  double log_density(const Path& x, const Path& y, const Kept& kept) const final;
  const RayCounts& ray_counts() const final { return rays_; }

 protected:
  /// The vertex that is the last to move; empty if the path is not of the kind.
  virtual std::optional<int> end_of(const Path& path) const = 0;
  /// The light, if paths run into it.
  static std::optional<int> end_at_light(const Path& path);

 private:
  bool grow(const Path& x, int end, const Vec2& raster, SampleSource& source);

  const Scene& scene_;
  const RasterArea& area_;
  PerturbationLaw raster_;
  PerturbationLaw direction_;
  GrowingPath growing_;
  RayCounts rays_;
};

}  // namespace ajar
