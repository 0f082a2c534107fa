#pragma once
#include <memory>

#include "integrator/preparation_stage.h"
#include "integrator/selective/chain_plan.h"

namespace ajar {

/// Renders the picture with few samples, to tell the chains roughly how bright it is where: for the
/// importance map, and for where the light is divided. Nothing of it stays in the picture.
class ChainPilot final : public PreparationStage {
 public:
  explicit ChainPilot(ChainPlan& plan);
  double effort() const override;
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;

 private:
  /// RGB; of "direct" or "indirect" light.
  std::vector<float> colors(const char* layer) const;

  ChainPlan& plan_;
  std::unique_ptr<Integrator> omc_;
  std::unique_ptr<Film> film_;
};

}  // namespace ajar
