#pragma once
#include "mcmc/primary/mutation.h"

namespace ajar {

/// u' = u ± s2·exp(−ln(s2/s1)·ξ): step lengths between s1 and s2, each order of magnitude equally
/// likely. Source: Kelemen et al. 2002, section 5.
class KelemenMutation final : public Mutation {
 public:
  explicit KelemenMutation(double shortest = 1.0 / 1024.0, double longest = 1.0 / 64.0);
  std::string_view name() const override { return "kelemen"; }
  void perturb(std::span<float> numbers, std::span<const float> scales, double steps,
               std::uint64_t key) const override;
  double density(float from, float to, float scale) const override;

 private:
  double shortest_;
  double longest_;
  float octaves_;  ///< log2(longest / shortest)
};

}  // namespace ajar
