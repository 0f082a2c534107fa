#include "mcmc/chain_runner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "mcmc/counter_random.h"

namespace ajar {

namespace {

/// The smallest I that counts. The inverse of anything smaller may overflow.
constexpr double kSmallest = std::numeric_limits<double>::min();

double acceptance(double current, double proposal, double log_ratio) {
  if (proposal == 0.0) return 0.0;
  const double ratio =
      log_ratio == 0.0 ? proposal / current : proposal / current * std::exp(log_ratio);
  if (std::isnan(ratio)) return 0.0;
  return std::min(1.0, ratio);
}

[[noreturn]] void refuse(const Chain& chain, double replayed) {
  std::ostringstream message;
  message << std::hexfloat << "bug: the current state of a Markov chain has I = " << chain.scalar
          << ", but its replay gives " << replayed
          << ": the target is not a function of its primary numbers. To replay: Chain(shape, seed "
          << chain.seed << ", origin " << chain.origin << "), " << chain.step << " steps";
  throw std::logic_error(message.str());
}

}  // namespace

ChainRunner::ChainRunner(const ChainSettings& settings, const Mutation& mutation,
                         const PrimaryShape& shape, Target& target, const PlaneMoves* plane)
    : settings_(settings), target_(target), source_(mutation, settings.sizes, shape, plane) {
  settings_.probabilities.check();
  settings_.sizes.check();
}

void ChainRunner::start(const Chain& chain) {
  ReplaySource source(chain.numbers);
  current_.clear();
  const double scalar = target_.evaluate(source, Change{}, current_);
  if (!(scalar == chain.scalar && scalar >= kSmallest && std::isfinite(scalar))) {
    refuse(chain, scalar);
  }
  target_.accepted();
  source_.start(source.uses_raster(), chain.step_scale);
}

double ChainRunner::evaluate(const Chain& chain, const Change& change,
                             ChainStatistics& statistics) {
  proposal_.clear();
  const double scalar = target_.evaluate(source_, change, proposal_);
  if (scalar >= kSmallest && std::isfinite(scalar)) return scalar;
  if (scalar >= 0.0 && scalar < kSmallest) {
    ++statistics.zero;
    return 0.0;
  }
  if (std::isnan(scalar)) {
    ++statistics.discarded_nan;
  } else if (scalar < 0.0) {
    ++statistics.discarded_negative;
  } else {
    ++statistics.discarded_infinite;
  }
  if (!statistics.first_discarded) {
    statistics.first_discarded = {chain.seed, chain.origin, chain.step};
  }
  return 0.0;
}

ChainStatistics ChainRunner::go_on(Chain& chain, std::uint64_t steps, DepositSink& sink,
                                   std::optional<double> combined_b) {
  if (combined_b && !(*combined_b > 0.0 && std::isfinite(*combined_b))) {
    throw std::invalid_argument("large steps can be combined with the chain only for a b > 0");
  }
  ChainStatistics statistics;
  const double large_density = combined_b ? *combined_b * settings_.probabilities.large : 0.0;
  const auto deposit = [&](const SplatBuffer& splats, double weight, double scalar) {
    if (weight > 0.0) sink.deposit(splats, weight / (scalar + large_density));
  };
  double current_weight = 0.0;
  for (std::uint64_t i = 0; i < steps; ++i) {
    const std::uint64_t key = hash_numbers(chain.seed, chain.step);
    const StepKind kind = settings_.probabilities.choose(to_unit_double(counter_bits(key, 0)));
    const bool large = kind == StepKind::Large;
    const Change change = change_of(kind, settings_.connection);
    source_.propose(chain.numbers, kind, change, counter_bits(key, 1));
    const double scalar = evaluate(chain, change, statistics);
    const double a = acceptance(chain.scalar, scalar, source_.log_ratio());

    ++statistics.steps;
    ++statistics.of(kind).proposals;
    statistics.of(kind).acceptances += a;
    sink.proposed(current_, a);
    if (large) statistics.large_steps.add(scalar);

    const double proposal_weight = large && combined_b ? a + 1.0 : a;
    current_weight += 1.0 - a;
    if (to_unit_double(counter_bits(key, 2)) < a) {
      deposit(current_, current_weight, chain.scalar);
      source_.accept();
      chain.step_scale = source_.step_scale();
      target_.accepted();
      std::swap(current_, proposal_);
      current_weight = proposal_weight;
      chain.scalar = scalar;
      chain.streak = 0;
    } else {
      if (scalar > 0.0) deposit(proposal_, proposal_weight, scalar);
      source_.reject();
      target_.rejected();
      ++chain.streak;
      statistics.longest_streak = std::max(statistics.longest_streak, chain.streak);
    }
    ++chain.step;
  }
  deposit(current_, current_weight, chain.scalar);
  return statistics;
}

}  // namespace ajar
