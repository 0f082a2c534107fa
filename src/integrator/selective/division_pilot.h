#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/plane.h"
#include "integrator/preparation_stage.h"
#include "integrator/selective/preparation.h"
#include "integrator/selective/region_choice.h"
#include "integrator/selective/seed_reservoir.h"

namespace ajar {

/// Decisions of the pilot.
struct DivisionResult {
  std::vector<RegionChoice> choices;  ///< one, or one for each half of the replicates
  Divisions divisions;
  bool fireflies_only;    ///< chains pay nowhere
  Plane noise;            ///< impulse noise of the indirect light
  double chain_fraction;  ///< fraction of the picture (chain_fraction.h)
  std::uint64_t samples;  ///< samples of the pilot per pixel
};

/// Samples of ordinary Monte Carlo that decide how the light is divided (region_choice.h). They are
/// the first of the render, if they are kept; what they leave to chains is offered to the seed
/// reservoir.
class DivisionPilot final : public PreparationStage, public OutlierSinkFactory {
 public:
  /// Both must outlive it. The light is divided as `prepared` has it until `end`.
  DivisionPilot(const SelectivePreparation& prepared, SeedReservoir& reservoir)
      : prepared_(prepared), reservoir_(reservoir) {}
  double effort() const override;
  bool stays() const override {
    return prepared_.config.pilot != SelectiveConfig::PilotSamples::Discard;
  }
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  /// Decides with the regions that `prepared` has by then.
  void end() override;
  std::unique_ptr<OutlierSink> make(Film& film, Counters& counters) const override;
  /// After `end`: tests whether more regions might make chains pay.
  bool wants_regions() const;
  /// Decides anew, with other regions, for the halves for which there is hope. The others keep to
  /// what their samples have decided: whether regions were looked at is up to both.
  void refine();
  /// After the last decision.
  void close();
  /// Puts its samples on the film, divided as `prepared` has it by then.
  void hand_over(Film& film) override;

  /// After `end`; empty until then.
  const std::optional<DivisionResult>& result() const { return result_; }
  /// Camera samples, over all pixels, that have offered seeds to chains.
  double seeding_samples() const;

 private:
  class Sink;
  /// Replicates of the pilot; those of the render, if it is kept.
  int replicates() const;
  /// Samples per pixel: each replicate has as many.
  std::uint64_t planned_samples() const;
  /// Tests whether the finds of a replicate may start chains.
  bool offers(int replicate) const {
    // If the pilot is discarded, one half is for the division and the other for chains.
    return stays() || replicate % 2 == 1;
  }
  /// Replicates from which the division of a half is decided.
  std::vector<int> seen_by(std::size_t half) const;
  PilotView view(std::vector<int> replicates) const;
  RegionChoice choose(std::size_t half) const;
  Division division_of(const RegionChoice& choice) const;
  void conclude(std::vector<RegionChoice> choices);

  const SelectivePreparation& prepared_;
  SeedReservoir& reservoir_;
  std::uint64_t samples_ = 0;  ///< per pixel
  /// Ordinary Monte Carlo alone would find all light, and the user has set nothing.
  bool may_disable_chains_ = false;
  float threshold_ = 0.F;  ///< energy below which paths are kept by Russian roulette
  std::unique_ptr<Integrator> omc_;
  std::unique_ptr<Film> film_;
  std::atomic<std::uint64_t> rays_{0};
  mutable std::mutex mutex_;
  mutable std::vector<PilotPath> found_;
  std::optional<DivisionResult> result_;
};

}  // namespace ajar
