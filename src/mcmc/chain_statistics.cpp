#include "mcmc/chain_statistics.h"

#include <algorithm>

namespace ajar {

void add_counts(std::vector<MoveCount>& counts, const std::vector<MoveCount>& others) {
  counts.resize(std::max(counts.size(), others.size()));
  for (std::size_t i = 0; i < others.size(); ++i) counts[i] += others[i];
}

void ChainStatistics::count(const Candidate& candidate, const ChainPlace& place) {
  switch (candidate.fault) {
    case Fault::None:
      if (candidate.scalar == 0.0) ++zero;
      return;
    case Fault::NotANumber:
      ++discarded_nan;
      break;
    case Fault::Infinite:
      ++discarded_infinite;
      break;
    case Fault::Negative:
      ++discarded_negative;
      break;
  }
  if (!first_discarded) first_discarded = place;
}

ChainStatistics& ChainStatistics::operator+=(const ChainStatistics& other) {
  add_counts(moves, other.moves);
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
