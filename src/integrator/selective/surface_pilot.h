#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "image/plane.h"
#include "image/regions.h"
#include "integrator/preparation_stage.h"
#include "integrator/selective/chain_plan.h"

namespace ajar {

/// Looks at what each pixel shows, with camera rays of its own. What a pixel counts as must not
/// follow from samples of the picture: where objects meet, those that happen to see the brighter
/// one would be weighed by its map.
class SurfacePilot final : public PreparationStage {
 public:
  explicit SurfacePilot(const ChainPlan& plan) : plan_(plan) {}
  double effort() const override;
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;

  // After `end`; row by row of the crop.

  /// Object and material that most rays of a pixel met.
  const std::vector<PixelIdentity>& identities() const { return identities_; }
  /// Edges between surfaces (integrator/regions/surface_edges.h).
  const Plane& edges() const { return *edges_; }

 private:
  const ChainPlan& plan_;
  std::unique_ptr<Integrator> rays_;
  std::unique_ptr<Film> film_;
  std::vector<PixelIdentity> identities_;
  std::optional<Plane> edges_;
};

}  // namespace ajar
