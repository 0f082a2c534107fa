#pragma once
#include <vector>

#include "mcmc/kernel.h"
#include "mcmc/primary/chain_source.h"
#include "mcmc/primary/mutation.h"
#include "mcmc/primary/primary_chain.h"
#include "mcmc/primary/several_tries.h"
#include "mcmc/primary/step_kind.h"
#include "mcmc/primary/step_sizes.h"
#include "mcmc/primary/target.h"

namespace ajar {

/// Moves of chains of primary numbers.
struct PrimarySettings {
  StepProbabilities probabilities;
  StepSizes sizes;
  ConnectionMoves connection;
  /// Proposals of a step (`SeveralTries`). Steps that need not be symmetric have one nevertheless:
  /// those of the raster numbers alone, and those that follow the image plane.
  int tries = 1;
};

/// Steps in primary sample space (Kelemen et al. 2002): moves of the vector of uniform numbers that
/// a target's state is made of. The choice of a move does not depend on the state.
class PrimaryKernel final : public Kernel {
 public:
  /// The mutation, the target, and `plane`, which may be null, must outlive it. Raises
  /// std::invalid_argument for settings that cannot be, std::logic_error for fine steps of a
  /// mutation that does not divide.
  PrimaryKernel(const PrimarySettings& settings, const Mutation& mutation,
                const PrimaryShape& shape, Target& target, const PlaneMoves* plane = nullptr);

  /// Looks up the current state of a chain, and goes on with it, which must stay where it is
  /// meanwhile. Raises std::logic_error if the target does not give the state its I again.
  void start(PrimaryChain& chain);

  std::span<const Move> moves() const override { return primary_moves(); }
  double independent_candidates() const override {
    return settings_.probabilities.large * settings_.tries;
  }
  std::span<const Splat> current() const override { return current_; }
  Proposal propose(std::uint64_t key) override;
  void accept(std::size_t candidate) override;
  void reject() override;

 private:
  PrimaryStep choose_step(std::uint64_t key) const;
  /// True if the step has several candidates.
  bool tries_often(const PrimaryStep& step) const;

  PrimarySettings settings_;
  Target& target_;
  bool follows_plane_;
  ChainSource source_;
  SeveralTries tries_;
  PrimaryChain* chain_ = nullptr;
  PrimaryStep step_;
  SplatBuffer current_;
  Candidate candidate_;  ///< the candidate of steps that have one
};

}  // namespace ajar
