#pragma once
#include <cstdint>
#include <vector>

#include "core/archive_forward.h"

namespace ajar {

/// How much of the error that chains leave is due to where they could start, so that more mutations
/// do not make it smaller.
///
/// For each stretch of a render, chains start from a sample of all that was found before. What it
/// lacks, and what was found by luck, most of the next stretch's sample has from it; what the
/// mutations of a stretch bring, that stretch has alone. So the errors of successive stretches are
/// as alike as much of them lasts. With n samples behind the first stretch and m behind the second,
/// what is found has errors of correlation √(n/m): the mean of n samples and that of m of which
/// they are part.
class LastingError {
 public:
  /// To be told, at the end of each stretch, what chains have made until then: `light`, picture by
  /// picture, as `weighted_light` has it, at least two and always as many; the mean of stretches
  /// that add up to `weight`, more than before. `samples_behind`: > 0, those that the stretch's
  /// chains started from.
  void see(const std::vector<std::vector<float>>& light, double weight, double samples_behind);

  /// Of squared error as it is seen (visible_error.h), the mean over all stretches; from 0 to
  /// `kMost`.
  double share() const {
    return stretches_ > 0 ? sum_ / static_cast<double>(stretches_) : kUnknown;
  }
  /// Before two stretches can be compared.
  static constexpr double kUnknown = 0.3;
  /// Mutations are never in vain altogether.
  static constexpr double kMost = 0.9;

  std::uint64_t memory_bytes() const;
  void save_state(OutputArchive& archive) const;
  /// May raise any std::exception if the bytes make no sense.
  void load_state(InputArchive& archive);

 private:
  /// Differences between pictures that have the same expectation, pair after pair.
  std::vector<float> until_now_;  ///< times the weight
  std::vector<float> stretch_;    ///< of the last one, times its weight
  double samples_behind_ = 0.0;
  double sum_ = 0.0;  ///< of shares
  std::uint64_t stretches_ = 0;
};

}  // namespace ajar
