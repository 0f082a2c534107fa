#include "mcmc/primary/primary_kernel.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "core/random_use.h"
#include "mcmc/counter_random.h"

namespace ajar {

namespace {

constexpr auto kLength =
    static_cast<std::uint64_t>(RandomUse::StepLength);  // names randomness, beyond those of tries

[[noreturn]] void refuse(const PrimaryChain& chain, double replayed) {
  throw std::logic_error(
      fmt::format("bug: the current state of a Markov chain has I = {:a}, but its replay gives "
                  "{:a}: the target "
                  "is not a function of its primary numbers. To replay: PrimaryChain(shape, seed "
                  "{}, origin {}), "
                  "{} steps",
                  chain.scalar, replayed, chain.seed, chain.origin, chain.step));
}

}  // namespace

PrimaryKernel::PrimaryKernel(const PrimarySettings& settings, const Mutation& mutation,
                             const PrimaryShape& shape, Target& target, const PlaneMoves* plane)
    : settings_(settings),
      target_(target),
      follows_plane_(plane != nullptr),
      source_(mutation, settings.sizes, shape, plane),
      tries_(source_, shape, settings.tries) {
  settings_.probabilities.check();
  settings_.sizes.check();
  if (settings_.probabilities.fine > 0.0 && !mutation.divisible()) {
    throw std::logic_error("bug: fine steps are for mutations that divide");
  }
}

void PrimaryKernel::start(PrimaryChain& chain) {
  chain_ = &chain;
  ReplaySource source(chain.numbers);
  current_.clear();
  Candidate state;
  const double scalar = target_.evaluate(source, Change{}, current_);
  state.take(scalar);
  if (!(scalar == chain.scalar && state.scalar > 0.0)) refuse(chain, scalar);
  target_.accepted();
  source_.start(source.uses_raster(), chain.step_scale);
}

PrimaryStep PrimaryKernel::choose_step(std::uint64_t key) const {
  const StepKind kind = settings_.probabilities.choose(to_unit_double(counter_bits(key, 0)));
  return {key, kind, change_of(kind, settings_.connection, source_.uses_raster()),
          settings_.probabilities.choose_length(to_unit_double(counter_bits(key, kLength)))};
}

bool PrimaryKernel::tries_often(const PrimaryStep& step) const {
  if (settings_.tries == 1 || step.kind == StepKind::SmallRaster) return false;
  const bool may_follow_plane = follows_plane_ && !step.large() && step.change.camera;
  return !may_follow_plane || step.units != kStepUnits;
}

Proposal PrimaryKernel::propose(std::uint64_t key) {
  step_ = choose_step(key);
  source_.propose(chain_->numbers, step_.kind, step_.change, counter_bits(key, 1), step_.units);
  const auto move = move_of(step_.kind);
  if (tries_often(step_)) {
    return {move, tries_.propose(step_, target_, chain_->scalar)};
  }
  candidate_.splats.clear();
  candidate_.take(target_.evaluate(source_, step_.change, candidate_.splats));
  candidate_.probability =
      metropolis_hastings(chain_->scalar, candidate_.scalar, source_.log_ratio());
  return {move, {&candidate_, 1}};
}

void PrimaryKernel::accept(std::size_t candidate) {
  if (tries_often(step_)) {
    tries_.accept(candidate, step_, target_, chain_->numbers, current_);
  } else {
    source_.accept();
    target_.accepted();
    std::swap(current_, candidate_.splats);
  }
  chain_->step_scale = source_.step_scale();
}

void PrimaryKernel::reject() {
  source_.reject();
  if (!tries_often(step_)) target_.rejected();
}

}  // namespace ajar
