#pragma once
#include "integrator/chain_plan.h"
#include "integrator/strong_paths.h"

namespace ajar {

/// Spreads what a strong path carries over a chain that starts from it (Cline et al. 2005, "Energy
/// redistribution path tracing"): each state gets an equal part. Paths are found with probability
/// density, and carry energy, such that together they are distributed as the chains' target is; a
/// chain that leaves the target as it is only smooths them. So there is no b to be known and no
/// bootstrap, and each state stands for the same amount of light whatever path it comes from.
class ChainSpreaders final : public StrongPathSinks {
 public:
  explicit ChainSpreaders(const ChainPlan& plan) : plan_(plan) {}
  bool apart() const override { return false; }
  std::unique_ptr<StrongPathSink> make(Film& film, Counters& counters) const override;

 private:
  const ChainPlan& plan_;
};

}  // namespace ajar
