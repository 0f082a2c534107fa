#pragma once
#include "mcmc/primary/mutation.h"

namespace ajar {

/// u' = u + N(0, σ²) modulo 1. Any number of steps in a row is one step with σ·√n, and any part of
/// one as well.
/// Source: as in pbrt's `mlt`; wrapped normal distribution: Mardia & Jupp 2000, section 3.5.7.
class GaussianMutation final : public Mutation {
 public:
  explicit GaussianMutation(double sigma = 0.01);
  std::string_view name() const override { return "gaussian"; }
  void perturb(std::span<float> numbers, std::span<const float> scales, double steps,
               std::uint64_t key) const override;
  bool divisible() const override { return true; }
  double density(float from, float to, float scale) const override;

 private:
  double sigma_;
};

}  // namespace ajar
