#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "mcmc/kernel.h"

namespace ajar {

/// Outcomes of the steps of one kind.
struct MoveCount {
  std::uint64_t proposals = 0;
  double acceptances = 0.0;  ///< sum of the acceptance probabilities

  MoveCount& operator+=(const MoveCount& other) {
    proposals += other.proposals;
    acceptances += other.acceptances;
    return *this;
  }
  /// Mean acceptance probability; 0 without proposals.
  double acceptance() const {
    return proposals > 0 ? acceptances / static_cast<double>(proposals) : 0.0;
  }
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(proposals, acceptances);
  }
};

/// Outcomes and cost of a move.
struct MoveRecord : MoveCount {
  std::uint64_t dark = 0;  ///< proposals without light, or that came to nothing
  std::uint64_t rays = 0;  ///< 0 where kernels do not know
  std::uint64_t lost_walks = 0;
  std::uint64_t one_way_walks = 0;
  std::uint64_t without_density = 0;  ///< see `Proposal`

  /// Counts a proposal, which is accepted with this probability.
  void count(const Proposal& proposal, double acceptance);
  MoveRecord& operator+=(const MoveRecord& other);
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(proposals, acceptances, dark, rays, lost_walks, one_way_walks, without_density);
  }
};

/// Adds each count to that of the same place; the shorter of both is filled up.
template <typename Count>
void add_counts(std::vector<Count>& counts, const std::vector<Count>& others) {
  counts.resize(std::max(counts.size(), others.size()));
  for (std::size_t i = 0; i < others.size(); ++i) counts[i] += others[i];
}

/// Enough to replay a step: the chain's seed, and how many steps lie before it.
struct ChainPlace {
  std::uint64_t seed = 0;
  std::uint64_t step = 0;
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(seed, step);
  }
};

/// Statistics of chains' steps; summable over runs.
struct ChainStatistics {
  std::vector<MoveRecord> moves;  ///< numbered as in `Kernel::moves`; empty if there was no step
  std::uint64_t steps = 0;
  std::uint64_t zero = 0;  ///< proposals with I = 0, not counting the discarded
  std::uint64_t discarded_nan = 0;
  std::uint64_t discarded_infinite = 0;
  std::uint64_t discarded_negative = 0;
  std::optional<ChainPlace> first_discarded;
  std::uint64_t longest_streak = 0;  ///< longest streak of rejections

  /// A candidate of the step at `place`.
  void count(const Candidate& candidate, const ChainPlace& place);
  /// Steps without a suitable move.
  std::uint64_t idle_steps() const;
  ChainStatistics& operator+=(const ChainStatistics& other);

  /// Writes or reads all of it, see core/archive.h.
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(moves, steps, zero, discarded_nan, discarded_infinite, discarded_negative,
            first_discarded, longest_streak);
  }
};

}  // namespace ajar
