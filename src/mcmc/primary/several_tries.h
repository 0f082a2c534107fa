#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "mcmc/kernel.h"
#include "mcmc/primary/target.h"
#include "mcmc/primary/try_source.h"

namespace ajar {

/// Multiple-try Metropolis in primary sample space: a step makes N proposals y_1 … y_N and chooses
/// one in proportion to I. Those of a large step are independent. Those of a small step are one
/// step each from a point that is one step from the current state x and is not evaluated: given
/// that point, x and all y_i are equally distributed, so the reference set of multiple-try
/// Metropolis for y_j is x and the other y_i (Craiu & Lemieux 2007: correlated tries). With W =
/// Σ I(y_i), y_j is accepted with probability min(1, W / (W − I(y_j) + I(x))), known for each
/// without further evaluations. Detailed balance, given the point and the other tries: the flow
/// from x to y_j is I(x)·I(y_j)·min(1/W, 1/(W − I(y_j) + I(x))), the same in both directions. Steps
/// must be symmetric for that. A step evaluates N states, and one more if it is accepted.
class SeveralTries {
 public:
  /// `source`, whose proposals are the points in the middle, must outlive it.
  SeveralTries(ChainSource& source, const PrimaryShape& shape, int tries);

  /// The candidates of a step that `source` has begun from a state of I = `current`.
  std::span<const Candidate> propose(const PrimaryStep& step, Target& target, double current);
  /// Goes to a candidate of the step; `current` becomes its splats.
  void accept(std::size_t candidate, const PrimaryStep& step, Target& target, ChainNumbers& numbers,
              SplatBuffer& current);

 private:
  void begin(std::size_t candidate, const PrimaryStep& step);
  void find_probabilities(double current);

  ChainSource& source_;
  TrySource try_source_;
  std::vector<Candidate> candidates_;
};

}  // namespace ajar
