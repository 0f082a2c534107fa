#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "mcmc/moments.h"
#include "mcmc/step_kind.h"

namespace ajar {

/// What happened in steps of chains; summable over runs.
struct ChainStatistics {
  struct Kind {
    std::uint64_t proposals = 0;
    double acceptances = 0.0;  ///< sum of the acceptance probabilities
  };
  /// Enough to replay a step: the chain's seed and origin, and how many steps lie before it.
  struct Place {
    std::uint64_t seed;
    std::uint64_t origin;
    std::uint64_t step;
  };
  std::array<Kind, kStepKinds> kinds;
  std::uint64_t steps = 0;
  std::uint64_t zero = 0;  ///< proposals with I = 0, not counting the discarded
  std::uint64_t discarded_nan = 0;
  std::uint64_t discarded_infinite = 0;
  std::uint64_t discarded_negative = 0;
  std::optional<Place> first_discarded;
  std::uint64_t longest_streak = 0;  ///< of rejections
  /// I of all large steps, up to a cap: independent samples, with which b can be refined.
  Moments large_steps;

  const Kind& of(StepKind kind) const { return kinds[static_cast<std::size_t>(kind)]; }
  Kind& of(StepKind kind) { return kinds[static_cast<std::size_t>(kind)]; }
  ChainStatistics& operator+=(const ChainStatistics& other);
};

}  // namespace ajar
