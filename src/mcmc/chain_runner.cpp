#include "mcmc/chain_runner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/random.h"
#include "mcmc/counter_random.h"

namespace ajar {

/// A call of `go_on`.
struct ChainRunner::Run {
  Chain& chain;
  DepositSink& sink;
  bool combined;
  double independent_density;   ///< b·p; 0 if not combined
  double current_weight = 0.0;  ///< weight of the current state, not deposited yet
  ChainStatistics statistics{};

  void deposit(std::span<const Splat> splats, double weight, double scalar) const {
    if (weight > 0.0) sink.deposit(splats, weight / (scalar + independent_density));
  }
  void count(const Proposal& proposal, double acceptance) {
    ++statistics.steps;
    if (!proposal.move) return;
    statistics.moves[*proposal.move].count(proposal, acceptance);
    for (const Candidate& candidate : proposal.candidates) {
      statistics.count(candidate, {chain.seed, chain.step});
    }
  }
};

void ChainRunner::make_step(Run& run) {
  Chain& chain = run.chain;
  const std::uint64_t key = hash_numbers(chain.seed, chain.step);
  const Proposal proposal = kernel_.propose(key);
  const std::span<const Candidate> candidates = proposal.candidates;
  const bool independent = proposal.move && moves_[*proposal.move].independent;

  const double u = to_unit_double(counter_bits(key, 2));
  double moves = 0.0;
  std::size_t chosen = candidates.size();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    moves += candidates[i].probability;
    if (chosen == candidates.size() && u < moves) chosen = i;
  }
  moves = std::min(1.0, moves);
  run.count(proposal, moves);
  run.sink.proposed(kernel_.current(), moves);

  run.current_weight += 1.0 - moves;
  const bool accepted = chosen < candidates.size();
  if (accepted) run.deposit(kernel_.current(), run.current_weight, chain.scalar);
  const double alone = independent && run.combined ? 1.0 : 0.0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& candidate = candidates[i];
    if (i != chosen && candidate.scalar > 0.0) {
      run.deposit(candidate.splats, candidate.probability + alone, candidate.scalar);
    }
  }
  if (accepted) {
    run.current_weight = candidates[chosen].probability + alone;
    chain.scalar = candidates[chosen].scalar;
    chain.streak = 0;
    kernel_.accept(chosen);
  } else {
    ++chain.streak;
    kernel_.reject();
  }
  run.statistics.longest_streak = std::max(run.statistics.longest_streak, chain.streak);
  ++chain.step;
}

ChainStatistics ChainRunner::go_on(Chain& chain, std::uint64_t steps, DepositSink& sink,
                                   std::optional<double> combined_b) {
  if (combined_b && !(*combined_b > 0.0 && std::isfinite(*combined_b))) {
    throw std::invalid_argument("large steps can be combined with the chain only for a b > 0");
  }
  Run run{chain, sink, combined_b.has_value(),
          combined_b.value_or(0.0) * kernel_.independent_candidates()};
  run.statistics.moves.resize(moves_.size());
  for (std::uint64_t i = 0; i < steps; ++i) make_step(run);
  run.deposit(kernel_.current(), run.current_weight, chain.scalar);
  return run.statistics;
}

}  // namespace ajar
