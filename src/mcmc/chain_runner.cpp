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

constexpr std::uint64_t kLength = 0x1e46ULL;  // names randomness, beyond those of tries

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
    : settings_(settings),
      target_(target),
      source_(mutation, settings.sizes, shape, plane),
      try_source_(source_, shape) {
  settings_.probabilities.check();
  settings_.sizes.check();
  if (settings_.tries > 1 && plane != nullptr) {
    throw std::logic_error("bug: several tries are for symmetric small steps only");
  }
  if (settings_.probabilities.fine > 0.0 && (!mutation.divisible() || plane != nullptr)) {
    throw std::logic_error(
        "bug: fine steps are for mutations that divide, without moves of the plane");
  }
  if (settings_.probabilities.raster > 0.0 && (settings_.tries > 1 || plane != nullptr)) {
    throw std::logic_error(
        "bug: steps of the raster numbers alone are for one try, without moves of the plane");
  }
  if (settings_.tries > 1) tries_.resize(static_cast<std::size_t>(settings_.tries));
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

double ChainRunner::evaluate(Run& run, SampleSource& source, const Change& change,
                             SplatBuffer& splats) {
  splats.clear();
  ChainStatistics& statistics = run.statistics;
  const double scalar = target_.evaluate(source, change, splats);
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
    statistics.first_discarded = {run.chain.seed, run.chain.origin, run.chain.step};
  }
  return 0.0;
}

void ChainRunner::make_step(Run& run, const Step& step) {
  Chain& chain = run.chain;
  source_.propose(chain.numbers, step.kind, step.change, counter_bits(step.key, 1), step.units);
  const double scalar = evaluate(run, source_, step.change, proposal_);
  const double a = acceptance(chain.scalar, scalar, source_.log_ratio());

  run.statistics.of(step.kind).acceptances += a;
  run.sink.proposed(current_, a);
  if (step.large()) run.statistics.large_steps.add(std::min(scalar, settings_.large_step_cap));

  const double proposal_weight = step.large() && run.combined ? a + 1.0 : a;
  run.current_weight += 1.0 - a;
  if (to_unit_double(counter_bits(step.key, 2)) < a) {
    run.deposit(current_, run.current_weight, chain.scalar);
    source_.accept();
    chain.step_scale = source_.step_scale();
    target_.accepted();
    std::swap(current_, proposal_);
    run.current_weight = proposal_weight;
    chain.scalar = scalar;
    chain.streak = 0;
  } else {
    if (scalar > 0.0) run.deposit(proposal_, proposal_weight, scalar);
    source_.reject();
    target_.rejected();
    ++chain.streak;
  }
}

void ChainRunner::begin_try(const Step& step, std::size_t index) {
  const std::uint64_t key = counter_bits(step.key, 3 + index);
  if (step.large()) {
    try_source_.make_fresh(key);
  } else {
    try_source_.move_from_centre(step.change, key);
  }
}

void ChainRunner::evaluate_tries(Run& run, const Step& step) {
  for (std::size_t i = 0; i < tries_.size(); ++i) {
    begin_try(step, i);
    tries_[i].scalar = evaluate(run, try_source_, step.change, tries_[i].splats);
    if (step.large()) {
      run.statistics.large_steps.add(std::min(tries_[i].scalar, settings_.large_step_cap));
    }
    // Tries are alike, so it does not matter which of them speaks for the step.
    if (i + 1 == tries_.size()) run.sink.proposed(current_, find_probabilities(run.chain.scalar));
    target_.rejected();
  }
}

double ChainRunner::find_probabilities(double current) {
  double all = 0.0;
  for (const Try& one : tries_) all += one.scalar;
  double sum = 0.0;
  for (std::size_t i = 0; i < tries_.size(); ++i) {
    Try& one = tries_[i];
    // Added up anew, since a difference could vanish by rounding.
    double reference = current;
    for (std::size_t j = 0; j < tries_.size(); ++j) {
      if (j != i) reference += tries_[j].scalar;
    }
    one.probability = one.scalar > 0.0 ? one.scalar / std::max(all, reference) : 0.0;
    sum += one.probability;
  }
  return std::min(1.0, sum);
}

void ChainRunner::move_to(Run& run, const Step& step, std::size_t index) {
  Chain& chain = run.chain;
  // The target must see once more what is to become its current state.
  begin_try(step, index);
  proposal_.clear();
  target_.evaluate(try_source_, step.change, proposal_);
  target_.accepted();
  const std::uint64_t key = counter_bits(step.key, 3 + index);
  if (step.large()) {
    chain.numbers.advance_to_fresh(key);
  } else {
    source_.accept_moved(key);
  }
  std::swap(current_, proposal_);
  chain.scalar = tries_[index].scalar;
  chain.streak = 0;
}

void ChainRunner::make_step_of_tries(Run& run, const Step& step) {
  Chain& chain = run.chain;
  // The point in the middle; a large step has none, and leaves it untouched.
  source_.propose(chain.numbers, step.kind, step.change, counter_bits(step.key, 1), step.units);
  evaluate_tries(run, step);

  double moves = 0.0;
  std::size_t chosen = tries_.size();
  const double u = to_unit_double(counter_bits(step.key, 2));
  for (std::size_t i = 0; i < tries_.size(); ++i) {
    moves += tries_[i].probability;
    if (chosen == tries_.size() && u < moves) chosen = i;
  }
  run.statistics.of(step.kind).acceptances += std::min(1.0, moves);
  run.current_weight += std::max(0.0, 1.0 - moves);
  if (chosen < tries_.size()) run.deposit(current_, run.current_weight, chain.scalar);
  const double alone = step.large() && run.combined ? 1.0 : 0.0;
  for (std::size_t i = 0; i < tries_.size(); ++i) {
    const Try& one = tries_[i];
    if (i != chosen && one.scalar > 0.0) {
      run.deposit(one.splats, one.probability + alone, one.scalar);
    }
  }
  if (chosen < tries_.size()) {
    move_to(run, step, chosen);
    run.current_weight = tries_[chosen].probability + alone;
  } else {
    source_.reject();
    ++chain.streak;
  }
}

ChainStatistics ChainRunner::go_on(Chain& chain, std::uint64_t steps, DepositSink& sink,
                                   std::optional<double> combined_b) {
  if (combined_b && !(*combined_b > 0.0 && std::isfinite(*combined_b))) {
    throw std::invalid_argument("large steps can be combined with the chain only for a b > 0");
  }
  const double large = settings_.probabilities.large * std::max(1, settings_.tries);
  Run run{chain, sink, combined_b.has_value(), combined_b.value_or(0.0) * large};
  for (std::uint64_t i = 0; i < steps; ++i) {
    const std::uint64_t key = hash_numbers(chain.seed, chain.step);
    const StepKind kind = settings_.probabilities.choose(to_unit_double(counter_bits(key, 0)));
    const Step step{
        key, kind, change_of(kind, settings_.connection, source_.uses_raster()),
        settings_.probabilities.choose_length(to_unit_double(counter_bits(key, kLength)))};
    ++run.statistics.steps;
    ++run.statistics.of(kind).proposals;
    if (tries_.empty()) {
      make_step(run, step);
    } else {
      make_step_of_tries(run, step);
    }
    run.statistics.longest_streak = std::max(run.statistics.longest_streak, chain.streak);
    ++chain.step;
  }
  run.deposit(current_, run.current_weight, chain.scalar);
  return run.statistics;
}

}  // namespace ajar
