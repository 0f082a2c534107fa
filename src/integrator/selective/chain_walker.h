#pragma once
#include <cstdint>
#include <memory>
#include <span>

#include "integrator/metropolis/divided_path_weight.h"
#include "integrator/selective/preparation.h"
#include "integrator/selective/selective_chain.h"
#include "mcmc/chain_runner.h"

namespace ajar {

/// Makes the steps of chains, of one group in one replicate, on one thread.
class ChainWalker {
 public:
  virtual ~ChainWalker() = default;
  /// Looks up a chain's current state. It may go on several times then, as long as no other one has
  /// been started.
  virtual void start(SelectiveChain& chain) = 0;
  virtual ChainStatistics go_on(SelectiveChain& chain, std::uint64_t steps, DepositSink& sink) = 0;
  /// Null if its states are of no technique.
  virtual const PathTarget* target() const = 0;
  /// Traced so far.
  virtual RayCounts ray_counts() const = 0;
};

/// `prepared` must outlive it.
std::unique_ptr<ChainWalker> make_chain_walker(const SelectivePreparation& prepared,
                                               const PathGroup& group, int replicate);

/// Moves of the chains of a group.
std::span<const Move> moves_of(const PathGroup& group);

/// Weight of explicit paths for the chains of one group in a replicate. `prepared` must outlive it.
DividedPathWeight path_weight_of(const SelectivePreparation& prepared, const PathGroup& group,
                                 int replicate);

}  // namespace ajar
