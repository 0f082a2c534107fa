#pragma once
#include "integrator/preparation_stage.h"
#include "integrator/sample_block.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_population.h"

namespace ajar {

/// One for each replicate and group, without chains yet.
std::vector<ChainPopulation> make_populations(const ChainPlan& plan);

/// Finds b and seeds for the chains of every depth and replicate (docs/chains.md).
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
  void seed_replicate(int replicate);

  const ChainPlan& plan_;
  std::vector<ChainPopulation>& populations_;
  std::vector<SampleBlock> blocks_;
};

}  // namespace ajar
