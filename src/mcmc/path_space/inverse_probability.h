#pragma once
#include <bit>
#include <cstdint>

#include "core/random.h"
#include "mcmc/counter_random.h"

namespace ajar {

/// When counting tries is up to Russian roulette.
struct CountingRoulette {
  std::uint64_t sure;  ///< tries before it asks for the first time, a power of 2; then at each
                       ///< doubling
  double goes_on;      ///< probability; below ½, else what hardly ever succeeds takes without end
};

/// 1 over the probability P with which `succeeds(i)` does, i counting independent tries from 1: the
/// mean, over `key` too, of the tries it takes. 0 if roulette ends the count, more than the tries
/// if it does not. With a `discount` d below 1 try j counts d^(j − 1) only, and the mean is
/// 1/(1 − d + d P), however small P is; what is beyond the precision of a float is not tried.
template <typename Succeeds>
double inverse_probability(const Succeeds& succeeds, double discount,
                           const CountingRoulette& roulette, std::uint64_t key) {
  constexpr double kNegligible = 0x1p-24;
  double survivor_weight = 1.0;
  double count = 0.0;
  double weight = 1.0;
  for (std::uint64_t tries = 1;; ++tries) {
    count += weight;
    weight *= discount;
    if (succeeds(tries) || weight < kNegligible) return survivor_weight * count;
    if (tries < roulette.sure || !std::has_single_bit(tries)) continue;
    if (to_unit_double(hash_numbers(key, tries)) >= roulette.goes_on) return 0.0;
    survivor_weight /= roulette.goes_on;
  }
}

}  // namespace ajar
