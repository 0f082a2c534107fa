#pragma once
#include <memory>
#include <vector>

#include "integrator/chain_plan.h"
#include "integrator/chain_population.h"
#include "integrator/chain_recruits.h"
#include "integrator/preparation_stage.h"

namespace ajar {

/// Runs ordinary Monte Carlo ahead of the render, where the light is divided: what it leaves to
/// chains are their first seeds, and how much of the light that is decides how the time is shared
/// out (`ChainPlan::omc_samples`), if the user has not. Nothing of it stays in the picture.
class ChainScout final : public PreparationStage {
 public:
  ChainScout(ChainPlan& plan, std::vector<ChainPopulation>& populations, ChainRecruits& recruits)
      : plan_(plan), populations_(populations), recruits_(recruits) {}
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;

 private:
  ChainPlan& plan_;
  std::vector<ChainPopulation>& populations_;
  ChainRecruits& recruits_;
  std::uint64_t samples_ = 1;  ///< per pixel
  std::unique_ptr<Integrator> omc_;
  std::unique_ptr<Film> film_;
  /// Left to chains, of each item: added up in order, so that the bits do not vary.
  std::vector<double> strong_light_;
};

}  // namespace ajar
