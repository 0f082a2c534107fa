#pragma once
#include <cstdint>

namespace ajar {

/// State of every Markov chain between two runs, in any state space: plain data. With its state,
/// which its kernel knows, it is a pure function of its start and the number of its steps.
struct Chain {
  std::uint64_t seed = 0;
  std::uint64_t step = 0;    ///< made so far
  std::uint64_t streak = 0;  ///< rejections since the last acceptance
  double scalar = 0.0;       ///< I of the current state

  /// Writes or reads it, see core/archive.h.
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(seed, step, streak, scalar);
  }
};

}  // namespace ajar
