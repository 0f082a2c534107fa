#include "mcmc/chain_statistics.h"

#include <algorithm>

namespace ajar {

void MoveRecord::count(const Proposal& proposal, double acceptance) {
  ++proposals;
  acceptances += acceptance;
  rays += proposal.rays;
  if (std::all_of(proposal.candidates.begin(), proposal.candidates.end(),
                  [](const Candidate& candidate) { return candidate.scalar == 0.0; })) {
    ++dark;
  }
  if (proposal.walk == WalkEnd::Lost) ++lost_walks;
  if (proposal.walk == WalkEnd::OneWay) ++one_way_walks;
  if (proposal.without_density) ++without_density;
}

MoveRecord& MoveRecord::operator+=(const MoveRecord& other) {
  MoveCount::operator+=(other);
  dark += other.dark;
  rays += other.rays;
  lost_walks += other.lost_walks;
  one_way_walks += other.one_way_walks;
  without_density += other.without_density;
  return *this;
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

std::uint64_t ChainStatistics::idle_steps() const {
  std::uint64_t idle = steps;
  for (const MoveRecord& move : moves) idle -= std::min(idle, move.proposals);
  return idle;
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
  return *this;
}

}  // namespace ajar
