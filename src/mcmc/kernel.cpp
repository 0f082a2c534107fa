#include "mcmc/kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ajar {

void Candidate::take(double value) {
  // The inverse of anything smaller may overflow.
  constexpr double kSmallest = std::numeric_limits<double>::min();
  fault = Fault::None;
  scalar = 0.0;
  if (value >= kSmallest && std::isfinite(value)) {
    scalar = value;
  } else if (std::isnan(value)) {
    fault = Fault::NotANumber;
  } else if (value < 0.0) {
    fault = Fault::Negative;
  } else if (std::isinf(value)) {
    fault = Fault::Infinite;
  }
}

double metropolis_hastings(double current, double proposal, double log_ratio) {
  if (proposal == 0.0) return 0.0;
  const double ratio =
      log_ratio == 0.0 ? proposal / current : proposal / current * std::exp(log_ratio);
  if (std::isnan(ratio)) return 0.0;
  return std::min(1.0, ratio);
}

}  // namespace ajar
