#pragma once
#include <optional>
#include <vector>

#include "integrator/preparation_stage.h"
#include "integrator/selective/preparation.h"

namespace ajar {

/// Finds out what ordinary Monte Carlo's rays have to bring (`RayPrice`), and what they do: a few
/// thousand camera samples, which do not stay.
///
/// If all camera subpaths of throughput β survive with probability q = Λ · β / √(V/C), the product
/// V · C of variance and rays is smallest for
///
///     Λ² = Σ B²/β / Σ β · R
///
/// over all vertices where roulette may end a subpath, B being what the rest of it brings and R the
/// rays that this takes. V and C are of the whole picture; Rath et al. 2022 know them, B and R
/// place by place, from a render that learns as it goes on.
class RoulettePilot final : public PreparationStage {
 public:
  explicit RoulettePilot(const SelectivePreparation& prepared);
  double effort() const override;
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;
  /// After `end`; empty if there was too little light to tell.
  const std::optional<RayPrice>& price() const { return price_; }

 private:
  class Sink;
  struct Sums {
    double variance = 0.0;  ///< V of all camera samples
    double rays = 0.0;
    double brought = 0.0;  ///< B²/β
    double taken = 0.0;    ///< β · R
  };

  const SelectivePreparation& prepared_;
  PathSamplerSettings sampler_;
  std::vector<Sums> sums_;  ///< sums of each item
  std::optional<RayPrice> price_;
};

}  // namespace ajar
