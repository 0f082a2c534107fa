#include "mcmc/chain_statistics.h"

#include <algorithm>

namespace ajar {

ChainStatistics& ChainStatistics::operator+=(const ChainStatistics& other) {
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    kinds[i].proposals += other.kinds[i].proposals;
    kinds[i].acceptances += other.kinds[i].acceptances;
  }
  steps += other.steps;
  zero += other.zero;
  discarded_nan += other.discarded_nan;
  discarded_infinite += other.discarded_infinite;
  discarded_negative += other.discarded_negative;
  if (!first_discarded) first_discarded = other.first_discarded;
  longest_streak = std::max(longest_streak, other.longest_streak);
  large_steps += other.large_steps;
  return *this;
}

}  // namespace ajar
