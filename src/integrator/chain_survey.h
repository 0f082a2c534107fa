#pragma once
#include <memory>
#include <vector>

#include "integrator/chain_plan.h"
#include "integrator/preparation_stage.h"

namespace ajar {

/// Finds out how much of the light falls to chains once it is divided, and how many mutations a
/// camera sample therefore deserves (`selective`). Nothing of it stays in the picture.
///
/// Relative to the brightness of a pixel, let one camera sample have the variance V ≈ 1 and cost c,
/// a mutation cost c', and let chains make the share r of the light, with variance C r² per
/// mutation. The error after a given time is least for m = r · sqrt(C c / (c' V)) mutations per
/// sample. C ≈ 10 and c/c' ≈ 3 were measured on several scenes; the minimum is flat.
class ChainSurvey final : public PreparationStage {
 public:
  explicit ChainSurvey(ChainPlan& plan) : plan_(plan) {}
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;

 private:
  ChainPlan& plan_;
  std::unique_ptr<Integrator> omc_;
  std::unique_ptr<Film> film_;
  std::vector<double> strong_;  ///< per item
};

}  // namespace ajar
