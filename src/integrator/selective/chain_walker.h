#pragma once
#include <cstdint>
#include <memory>
#include <span>

#include "integrator/metropolis/path_share.h"
#include "integrator/selective/chain_plan.h"
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
  /// `b`: of the group in the replicate.
  virtual ChainStatistics go_on(SelectiveChain& chain, std::uint64_t steps, DepositSink& sink,
                                double b) = 0;
  /// Null if its states are of no technique.
  virtual const PathTarget* target() const = 0;
  /// Traced so far.
  virtual RayCounts ray_counts() const = 0;
};

/// For the chains of a plan, which must outlive it. `plane`: of chains of primary numbers, null if
/// steps do not follow the image plane.
std::unique_ptr<ChainWalker> make_chain_walker(const ChainPlan& plan, const PathGroup& group,
                                               int replicate, const PlaneMoves* plane);

/// How the chains of a group move.
std::span<const Move> moves_of(const PathGroup& group);

/// What chains of explicit paths, of one group, make of them in a replicate. The plan must outlive
/// it.
PathShare path_share_of(const ChainPlan& plan, const PathGroup& group, int replicate);

}  // namespace ajar
