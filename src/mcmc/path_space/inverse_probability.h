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

/// 1 over the probability with which `succeeds(i)` does, i counting independent tries from 1: the
/// mean, over `lots` too, of the tries it takes. 0 if roulette ends the count, more than the tries
/// if it does not.
template <typename Succeeds>
double inverse_probability(const Succeeds& succeeds, const CountingRoulette& roulette,
                           std::uint64_t lots) {
  double worth = 1.0;
  for (std::uint64_t tries = 1;; ++tries) {
    if (succeeds(tries)) return worth * static_cast<double>(tries);
    if (tries < roulette.sure || !std::has_single_bit(tries)) continue;
    if (to_unit_double(hash_numbers(lots, tries)) >= roulette.goes_on) return 0.0;
    worth /= roulette.goes_on;
  }
}

}  // namespace ajar
