#pragma once
#include <memory>
#include <vector>

#include "integrator/chain_plan.h"
#include "integrator/preparation_stage.h"

namespace ajar {

/// Finds out with which techniques, and how many light subpaths per camera sample, ordinary Monte
/// Carlo has the least error in the same time: where next event estimation reaches nearly
/// everything, inner connections cost more than they bring; where lamps hide in shades, several
/// light subpaths are worth their rays. Renders some tiles of the picture with each. Nothing of it
/// stays in the picture.
class TechniquePilot final : public PreparationStage {
 public:
  explicit TechniquePilot(ChainPlan& plan);
  ~TechniquePilot() override;
  TechniquePilot(const TechniquePilot&) = delete;
  TechniquePilot& operator=(const TechniquePilot&) = delete;
  double effort() const override;
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;

 private:
  class Candidate;

  ChainPlan& plan_;
  std::vector<std::unique_ptr<Candidate>> candidates_;
  std::vector<std::uint64_t> tiles_;
};

}  // namespace ajar
