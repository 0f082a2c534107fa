#pragma once
#include <optional>
#include <vector>

#include "integrator/preparation_stage.h"
#include "integrator/selective/preparation.h"
#include "integrator/selective/technique_errors.h"

namespace ajar {

/// Finds out with which techniques, and how many light subpaths per camera sample, ordinary Monte
/// Carlo has the least error in the same time: where next event estimation reaches nearly
/// everything, light subpaths cost more than they bring; where lamps hide in shades, several are
/// worth their rays.
///
/// All techniques are tried at once, with one light subpath, and each offer is judged by them
/// (`TechniqueErrors`). Nothing that was rendered stays.
class TechniquePilot final : public PreparationStage {
 public:
  explicit TechniquePilot(const SelectivePreparation& prepared);
  double effort() const override;
  bool serves_alone() const override { return true; }
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;
  /// The offer of least error; empty if nothing was found, or not all there is.
  const std::optional<PathFamilyDefaults>& chosen() const { return chosen_; }

 private:
  class Sink;
  struct Found {
    TechniqueErrors errors;
    double rays = 0.0;
    RaysByUse rays_by_use;
  };
  /// Kinds of light that an offer misses, or finds by chance alone.
  std::size_t blind_spots_of(const PathFamilyDefaults& offer) const;

  const SelectivePreparation& prepared_;
  PathSamplerSettings sampler_;
  std::vector<Found> found_;  ///< item by item
  std::optional<PathFamilyDefaults> chosen_;
};

}  // namespace ajar
