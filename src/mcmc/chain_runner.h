#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "mcmc/chain.h"
#include "mcmc/chain_source.h"
#include "mcmc/chain_statistics.h"
#include "mcmc/mutation.h"
#include "mcmc/step_kind.h"
#include "mcmc/step_sizes.h"
#include "mcmc/target.h"
#include "mcmc/try_source.h"

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
  int tries = 1;  ///< proposals per step
  /// What more than this a large step brings does not count in the statistics of b.
  double large_step_cap = std::numeric_limits<double>::infinity();
};

/// Runs Metropolis–Hastings chains: the only place where proposals are accepted and rejected. Holds
/// the scratch memory of one thread; the target and the mutation must outlive it.
class ChainRunner {
 public:
  /// `plane`, which may be null, must outlive it, too; it cannot be had with several tries or fine
  /// steps, nor the latter without a mutation that divides.
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
  /// With several `tries`, a step makes N proposals y_1 … y_N and chooses one in proportion to I.
  /// Those of a large step are independent. Those of a small step are one step each from a point
  /// that is one step from the current state x and is not evaluated: given that point, x and all
  /// y_i are equally distributed, so the reference set of multiple-try Metropolis for y_j is x and
  /// the other y_i (Craiu & Lemieux 2007: correlated tries). With W = Σ I(y_i), y_j is accepted
  /// with probability min(1, W / (W − I(y_j) + I(x))), known for each without further evaluations:
  /// all tries are deposited with their probabilities p_j to be chosen and accepted, the current
  /// state with 1 − Σ p_j. Detailed balance, given the point and the other tries: the flow from x
  /// to y_j is I(x)·I(y_j)·min(1/W, 1/(W − I(y_j) + I(x))), the same in both directions.
  /// A step evaluates N states, and one more if it is accepted. With `combined_b`, p above is N
  /// times the probability of large steps.
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
  /// A call of `go_on`.
  struct Run {
    Chain& chain;
    DepositSink& sink;
    bool combined;
    double large_density;         ///< b·p; 0 if not combined
    double current_weight = 0.0;  ///< of the current state, not deposited yet
    ChainStatistics statistics{};

    void deposit(const SplatBuffer& splats, double weight, double scalar) {
      if (weight > 0.0) sink.deposit(splats, weight / (scalar + large_density));
    }
  };
  /// What a step knows before it proposes.
  struct Step {
    std::uint64_t key;
    StepKind kind;
    Change change;
    std::uint64_t units;
    bool large() const { return kind == StepKind::Large; }
  };
  struct Try {
    double scalar = 0.0;
    double probability = 0.0;  ///< to be the next state
    SplatBuffer splats;
  };

  double evaluate(Run& run, SampleSource& source, const Change& change, SplatBuffer& splats);
  void make_step(Run& run, const Step& step);
  void make_step_of_tries(Run& run, const Step& step);
  void begin_try(const Step& step, std::size_t index);
  void evaluate_tries(Run& run, const Step& step);
  /// Of those evaluated; their sum.
  double find_probabilities(double current);
  void move_to(Run& run, const Step& step, std::size_t index);

  ChainSettings settings_;
  Target& target_;
  ChainSource source_;
  SplatBuffer current_;
  SplatBuffer proposal_;
  TrySource try_source_;
  std::vector<Try> tries_;  ///< empty if there is one try
};

}  // namespace ajar
