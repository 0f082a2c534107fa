#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "mcmc/chain.h"
#include "mcmc/chain_source.h"
#include "mcmc/chain_statistics.h"
#include "mcmc/mutation.h"
#include "mcmc/step_kind.h"
#include "mcmc/step_sizes.h"
#include "mcmc/target.h"

namespace ajar {

/// Receives the states of a chain. Each splat counts with value · `factor`; the mean over all
/// steps, times b, is the integral.
class DepositSink {
 public:
  virtual ~DepositSink() = default;
  virtual void deposit(std::span<const Splat> splats, double factor) = 0;
  /// A step from `current` whose proposal, the target's last state, is accepted with this
  /// probability: for statistics.
  virtual void proposed(std::span<const Splat> /*current*/, double /*acceptance*/) {}
};

struct ChainSettings {
  StepProbabilities probabilities;
  StepSizes sizes;
  ConnectionMoves connection;
};

/// Runs Metropolis–Hastings chains: the only place where proposals are accepted and rejected. Holds
/// the scratch memory of one thread; the target and the mutation must outlive it.
class ChainRunner {
 public:
  /// `plane`, which may be null, must outlive it, too.
  ChainRunner(const ChainSettings& settings, const Mutation& mutation, const PrimaryShape& shape,
              Target& target, const PlaneMoves* plane = nullptr);

  /// Makes `steps` steps. A step deposits its proposal with weight a, the probability to accept it,
  /// and the current state with 1 − a, each over its I ("expected values", Veach 1997, section
  /// 11.2.3). Weights of a state that stays are added up first, so a run cut in two deposits the
  /// same light to rounding, and leaves the chain the same to the bit.
  ///
  /// With `combined_b` (`mis-large-steps`; Kelemen et al. 2002, section 5.2) the large steps count
  /// as ordinary Monte Carlo samples as well. N steps bring N samples of density I/b from the chain
  /// and on average N·p of density 1 from its large steps, p being their probability. The balance
  /// heuristic gives a sample of either kind f / (N·I/b + N·p); times N/b, the deposit is
  ///
  ///     (a + 1[large]) · f' / (I' + b·p)   for the proposal,
  ///     (1 − a) · f / (I + b·p)            for the current state.
  ///
  /// The weights are right for the true b only: an error of b is an error of the picture, but a
  /// smaller one than without, since it cancels where large steps do the work.
  ///
  /// Raises std::logic_error if the target does not give the current state its I again.
  ChainStatistics run(Chain& chain, std::uint64_t steps, DepositSink& sink,
                      std::optional<double> combined_b = std::nullopt) {
    start(chain);
    return go_on(chain, steps, sink, combined_b);
  }
  /// The two parts of `run`: looks up the chain's current state, then makes steps. A chain that
  /// was started may go on several times as long as no other has been started.
  void start(const Chain& chain);
  ChainStatistics go_on(Chain& chain, std::uint64_t steps, DepositSink& sink,
                        std::optional<double> combined_b = std::nullopt);

 private:
  double evaluate(const Chain& chain, const Change& change, ChainStatistics& statistics);

  ChainSettings settings_;
  Target& target_;
  ChainSource source_;
  SplatBuffer current_;
  SplatBuffer proposal_;
};

}  // namespace ajar
