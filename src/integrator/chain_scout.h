#pragma once
#include <memory>
#include <vector>

#include "integrator/chain_plan.h"
#include "integrator/chain_population.h"
#include "integrator/chain_recruits.h"
#include "integrator/preparation_stage.h"

namespace ajar {

/// Runs ordinary Monte Carlo ahead of the render, where the light is divided: what it leaves to
/// chains are their first seeds, and how much of the light that is decides how many mutations the
/// first samples have (`ChainPlan::mutations`), if the user has not. Its samples are the first of
/// the render: how many they are depends on nothing that they find.
class ChainScout final : public PreparationStage {
 public:
  ChainScout(ChainPlan& plan, std::vector<ChainPopulation>& populations, ChainRecruits& recruits)
      : plan_(plan), populations_(populations), recruits_(recruits) {}
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;

  /// Puts what was rendered on the film of the render; to be called once.
  void hand_over(Film& film);

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
