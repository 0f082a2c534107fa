#pragma once
#include "integrator/preparation_stage.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_population.h"

namespace ajar {

inline std::vector<ChainPopulation> make_populations(const ChainPlan& plan) {
  return make_populations<ChainPopulation>(plan.groups, plan.settings.replicates,
                                           plan.settings.seed);
}

/// Finds b and seeds for the chains of every depth and replicate (docs/methods/divided-light.md).
class ChainBootstrap final : public PreparationStage {
 public:
  /// Fills `populations`, unless they are there already.
  ChainBootstrap(const ChainPlan& plan, std::vector<ChainPopulation>& populations)
      : plan_(plan), populations_(populations) {}
  double effort() const override;
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;

 private:
  const ChainPlan& plan_;
  std::vector<ChainPopulation>& populations_;
  std::vector<SampleBlock> blocks_;
};

}  // namespace ajar
