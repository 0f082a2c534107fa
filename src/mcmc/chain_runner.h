#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "mcmc/chain.h"
#include "mcmc/chain_statistics.h"
#include "mcmc/kernel.h"

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

/// Runs Markov chains in any space: the only place where proposals are accepted and rejected.
class ChainRunner {
 public:
  /// `kernel` must outlive it.
  explicit ChainRunner(Kernel& kernel) : kernel_(kernel), moves_(kernel.moves()) {}

  /// Makes `steps` steps of a chain that the kernel is at. A step deposits its proposal with weight
  /// a, the probability to accept it, and the current state with 1 − a, each over its I ("expected
  /// values", Veach 1997, section 11.2.3). Of several candidates, each is deposited with its own
  /// probability. Weights of a state that stays are added up first, so a run cut in two deposits
  /// the same light to rounding, and leaves the chain the same to the bit.
  ///
  /// With `combined_b` (`mis-large-steps`; Kelemen et al. 2002, section 5.2) independent candidates
  /// count as ordinary Monte Carlo samples as well. N steps give N samples of density I/b from the
  /// chain and on average N·p of density 1 from its large steps, p being the mean number per step.
  /// The balance heuristic gives a sample of either kind f / (N·I/b + N·p); times N/b, the deposit
  /// is
  ///
  ///     (a + 1[large]) · f' / (I' + b·p)   for the proposal,
  ///     (1 − a) · f / (I + b·p)            for the current state.
  ///
  /// The weights are right for the true b only: an error of b is an error of the picture, but a
  /// smaller one than without, since it cancels where large steps do the work. Raises
  /// std::invalid_argument unless it is above 0.
  ChainStatistics go_on(Chain& chain, std::uint64_t steps, DepositSink& sink,
                        std::optional<double> combined_b = std::nullopt);

 private:
  struct Run;
  void make_step(Run& run);

  Kernel& kernel_;
  std::span<const Move> moves_;
};

}  // namespace ajar
