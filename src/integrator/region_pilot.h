#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/plane.h"
#include "image/regions.h"
#include "integrator/chain_plan.h"
#include "integrator/chain_population.h"
#include "integrator/chain_recruits.h"
#include "integrator/preparation_stage.h"
#include "integrator/region_choice.h"

namespace ajar {

/// The pilot of `selective`: renders by ordinary Monte Carlo what the map of regions is made from
/// (region_choice.h). Its samples are the first of the render, if they stay; what they leave to
/// chains are the first seeds of these.
class RegionPilot final : public PreparationStage, public StrongPathSinks {
 public:
  /// `recruits` may be null. All must outlive it.
  RegionPilot(ChainPlan& plan, std::vector<ChainPopulation>& populations, ChainRecruits* recruits)
      : plan_(plan), populations_(populations), recruits_(recruits) {}
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;
  std::unique_ptr<StrongPathSink> make(Film& film, Counters& counters) const override;

  /// Puts what was rendered on the film of the render, if it is to stay; to be called once.
  void hand_over(Film& film);
  /// The layers "noise", "regions", "importance" and "edges", if they were asked for.
  std::vector<std::pair<std::string, Plane>> maps() const;
  std::optional<Plane> antialias_mask() const;
  std::uint64_t samples() const { return samples_; }  ///< per pixel
  /// Rows of the statistics, the largest regions first.
  std::vector<SelectiveReport::Region> report() const;

 private:
  class Sink;
  /// Replicates, of those of the pilot, that the map of half `half` (0 or 1) is made from.
  std::vector<int> seen_by(std::size_t half) const;
  /// Whether what a replicate finds may start chains.
  bool offers(int replicate) const;
  LightSplit split_of(const RegionChoice& choice) const;
  void join(const LightSplits& before);
  void find_edges(const std::vector<PixelIdentity>& identities);
  Plane importance() const;

  ChainPlan& plan_;
  std::vector<ChainPopulation>& populations_;
  ChainRecruits* recruits_;
  std::uint64_t samples_ = 0;  ///< per pixel
  double grain_ = 0.0;
  std::unique_ptr<Integrator> omc_;
  std::unique_ptr<Film> film_;
  std::atomic<std::uint64_t> rays_{0};
  double rays_per_sample_ = 1.0;
  mutable std::mutex mutex_;
  mutable std::vector<FoundLight> found_;
  Regions regions_;
  std::vector<RegionChoice> choices_;  ///< one, or one for each half
  std::optional<Plane> noise_;
  std::optional<Plane> edges_;
};

}  // namespace ajar
