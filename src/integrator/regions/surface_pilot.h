#pragma once
#include <memory>
#include <vector>

#include "core/plane.h"
#include "image/regions.h"
#include "integrator/preparation_stage.h"

namespace ajar {

/// Regions of a picture and the edges between its surfaces.
struct Surfaces {
  Regions regions;
  Plane edges{{0, 0}};  ///< integrator/regions/surface_edges.h
};

/// Finds the regions of the picture by camera rays of its own. They must not follow from samples of
/// the picture: at the border of an object, samples that happen to meet the brighter side would be
/// weighed by its region.
class SurfacePilot final : public PreparationStage {
 public:
  /// `settings`: of the picture.
  SurfacePilot(const Scene& scene, RenderSettings settings);
  double effort() const override;
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;

  /// After `end`.
  Surfaces take() { return std::move(surfaces_); }

 private:
  const Scene& scene_;
  RenderSettings settings_;
  std::unique_ptr<Integrator> rays_;
  std::unique_ptr<Film> film_;
  Surfaces surfaces_;
};

}  // namespace ajar
