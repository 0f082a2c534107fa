#pragma once
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/plane.h"
#include "image/regions.h"
#include "integrator/preparation_stage.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_population.h"
#include "integrator/selective/chain_recruits.h"
#include "integrator/selective/region_choice.h"
#include "integrator/selective/surface_pilot.h"

namespace ajar {

/// Layers that show what is decided about regions.
inline constexpr std::array<const char*, 4> kRegionLayers = {"noise", "regions", "importance",
                                                             "edges"};

/// Renders by ordinary Monte Carlo what decides how the light is divided (region_choice.h), in the
/// whole picture or, for `selective`, in each of its regions. Its samples are the first of the
/// render, if they stay; what they leave to chains are the first seeds of these.
class DivisionPilot final : public PreparationStage, public StrongPathSinks {
 public:
  /// `surfaces` tells what the regions of `selective` are; null where there are none. `recruits`
  /// may be null, too. All must outlive it.
  DivisionPilot(ChainPlan& plan, std::vector<ChainPopulation>& populations,
                const SurfacePilot* surfaces, ChainRecruits* recruits)
      : plan_(plan), populations_(populations), surfaces_(surfaces), recruits_(recruits) {}
  double effort() const override;
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;
  std::unique_ptr<StrongPathSink> make(Film& film, Counters& counters) const override;

  void hand_over(Film& film) override;

  /// Whether `end` has been called, and there is anything to decide.
  bool is_over() const { return regions_.count() > 0; }
  bool stays() const override { return plan_.pilot_use != PilotUse::Discard; }

  /// Those of `kRegionLayers` that were asked for; none if there was nothing to decide.
  std::vector<std::pair<std::string, Plane>> maps() const;
  std::optional<Plane> antialias_mask() const;
  std::uint64_t samples() const { return samples_; }  ///< per pixel
  /// Of the first region in each half, relative to the brightness of its pixels; empty until it is
  /// decided.
  std::vector<double> thresholds() const;
  /// Of the picture, as `chain_share` has it; empty if it was not looked at or is not decided.
  std::optional<double> share_of_chains() const { return share_of_chains_; }
  /// What each half of the replicates expects of chains, or all of them, by what the pilot has
  /// shown: `expected_error`, squared, with (bad) chains over that without, 1 if it is not known;
  /// `threshold` T, relative to the brightness, geometric mean over pixels; whether chains
  /// `stand_by`. Empty if nothing is decided.
  MethodReport expectations() const;
  /// A row for each region, the largest first: its number in the layer "regions", pixels, object
  /// and material, noise of the pilot's indirect light (½(mean + largest) above T), importance as
  /// in the layer of that name.
  MethodReport regions() const;

 private:
  class Sink;
  /// Of the pilot; those of the render, if it stays.
  int replicates() const;
  /// Per pixel: each replicate has as many.
  std::uint64_t planned_samples() const;
  /// Whether what it leaves to chains may become ordinary Monte Carlo's by its decisions.
  bool divides_anew() const;
  /// Whether what a replicate finds may start chains.
  bool offers(int replicate) const;
  /// Either all replicates have the same division, or the even and the odd ones (half 0 and 1) have
  /// one each.
  std::size_t halves() const { return plan_.pilot_use == PilotUse::Cross ? 2 : 1; }
  /// Replicates, of those of the pilot, from which the division of a half is decided.
  std::vector<int> seen_by(std::size_t half) const;
  void find_regions();
  PilotView view(std::vector<int> replicates) const;
  /// How the light is divided, and what chains start from.
  void decide();
  Division division_of(const RegionChoice& choice) const;
  void share_effort();
  /// Mutations per camera sample until the effort is shared by what the render shows of errors.
  double first_mutations() const;
  /// Camera samples that have offered seeds to chains.
  double recruiting_samples() const;
  void join();
  Plane importance() const;

  ChainPlan& plan_;
  std::vector<ChainPopulation>& populations_;
  const SurfacePilot* surfaces_;
  ChainRecruits* recruits_;
  std::uint64_t samples_ = 0;  ///< per pixel
  float grain_ = 0.F;
  std::unique_ptr<Integrator> omc_;
  std::unique_ptr<Film> film_;
  std::atomic<std::uint64_t> rays_{0};
  double rays_per_sample_ = 1.0;
  mutable std::mutex mutex_;
  mutable std::vector<FoundLight> found_;
  Regions regions_;
  std::vector<RegionChoice> choices_;  ///< one, or one for each half
  std::optional<Plane> noise_;         ///< of `selective` alone
  std::optional<double> share_of_chains_;
};

}  // namespace ajar
