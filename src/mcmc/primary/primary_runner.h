#pragma once
#include <optional>

#include "mcmc/chain_runner.h"
#include "mcmc/primary/primary_kernel.h"

namespace ajar {

/// Runs chains of primary numbers: a kernel and the runner of it.
class PrimaryRunner {
 public:
  /// Arguments of `PrimaryKernel`.
  PrimaryRunner(const PrimarySettings& settings, const Mutation& mutation,
                const PrimaryShape& shape, Target& target, const PlaneMoves* plane = nullptr)
      : kernel_(settings, mutation, shape, target, plane), runner_(kernel_) {}
  PrimaryRunner(const PrimaryRunner&) = delete;
  PrimaryRunner& operator=(const PrimaryRunner&) = delete;

  /// Looks up the chain's current state, then makes steps (`ChainRunner::go_on`).
  ChainStatistics run(PrimaryChain& chain, std::uint64_t steps, DepositSink& sink,
                      std::optional<double> combined_b = std::nullopt) {
    start(chain);
    return go_on(chain, steps, sink, combined_b);
  }
  /// The two parts of `run`. A chain that was started may go on several times as long as no other
  /// has been started.
  void start(PrimaryChain& chain) { kernel_.start(chain); }
  ChainStatistics go_on(PrimaryChain& chain, std::uint64_t steps, DepositSink& sink,
                        std::optional<double> combined_b = std::nullopt) {
    return runner_.go_on(chain, steps, sink, combined_b);
  }

 private:
  PrimaryKernel kernel_;
  ChainRunner runner_;
};

}  // namespace ajar
