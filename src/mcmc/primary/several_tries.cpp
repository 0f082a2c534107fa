#include "mcmc/primary/several_tries.h"

#include <algorithm>

#include "mcmc/counter_random.h"

namespace ajar {

namespace {
/// Names the randomness of a try, beyond that of the step itself.
std::uint64_t key_of(const PrimaryStep& step, std::size_t candidate) {
  constexpr std::uint64_t kFirst = 3;
  return counter_bits(step.key, kFirst + candidate);
}
}  // namespace

SeveralTries::SeveralTries(ChainSource& source, const PrimaryShape& shape, int tries)
    : source_(source),
      try_source_(source, shape),
      candidates_(tries > 1 ? static_cast<std::size_t>(tries) : 0) {}

void SeveralTries::begin(std::size_t candidate, const PrimaryStep& step) {
  if (step.large()) {
    try_source_.make_fresh(key_of(step, candidate));
  } else {
    try_source_.move_from_centre(step.change, key_of(step, candidate));
  }
}

std::span<const Candidate> SeveralTries::propose(const PrimaryStep& step, Target& target,
                                                 double current) {
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    Candidate& candidate = candidates_[i];
    begin(i, step);
    candidate.splats.clear();
    candidate.take(target.evaluate(try_source_, step.change, candidate.splats));
    target.rejected();
  }
  find_probabilities(current);
  return candidates_;
}

void SeveralTries::find_probabilities(double current) {
  double all = 0.0;
  for (const Candidate& one : candidates_) all += one.scalar;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    Candidate& one = candidates_[i];
    // Added up anew, since a difference could vanish by rounding.
    double reference = current;
    for (std::size_t j = 0; j < candidates_.size(); ++j) {
      if (j != i) reference += candidates_[j].scalar;
    }
    one.probability = one.scalar > 0.0 ? one.scalar / std::max(all, reference) : 0.0;
  }
}

void SeveralTries::accept(std::size_t candidate, const PrimaryStep& step, Target& target,
                          ChainNumbers& numbers, SplatBuffer& current) {
  // The target must see once more what is to become its current state.
  begin(candidate, step);
  current.clear();
  target.evaluate(try_source_, step.change, current);
  target.accepted();
  if (step.large()) {
    numbers.advance_to_fresh(key_of(step, candidate));
  } else {
    source_.accept_moved(key_of(step, candidate));
  }
  source_.arrive(try_source_.uses_raster(), try_source_.raster());
}

}  // namespace ajar
