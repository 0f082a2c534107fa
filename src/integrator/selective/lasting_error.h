#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/archive_forward.h"

namespace ajar {

/// How much of the error that chains leave is due to where they could start, so that more mutations
/// do not make it smaller.
///
/// For each stretch of a render, chains start from a sample of all that was found before. What it
/// lacks, and what was found by luck, later stretches have from it, too; what mutations bring is
/// forgotten after a while. So the errors of stretches that are some way apart are as alike as much
/// of them lasts. (Those of neighbours are more alike: chains go on from where they were.) With n
/// samples behind the first stretch and m behind the second, what is found has errors of
/// correlation √(n/m): the mean of n samples and that of m of which they are part.
class LastingError {
 public:
  /// With fewer than two replicates, nothing is ever known.
  LastingError(std::uint64_t pixels, int replicates);

  /// To be told, at the end of each stretch, what chains have made until then: `light`, replicate
  /// by replicate, as `weighted_light` has it; the mean of stretches that add up to `weight`, more
  /// than before. `samples_behind`: those that the stretch's chains started from.
  /// Raises std::invalid_argument if there are not as many pixels or replicates as there should be.
  void see(const std::vector<std::vector<float>>& light, double weight, double samples_behind);

  /// Of squared error as it is seen (visible_error.h), the mean over all stretches; from 0 to 1.
  /// None before there are stretches to compare.
  std::optional<double> share() const;

  std::uint64_t memory_bytes() const;
  void save_state(OutputArchive& archive) const;
  /// May raise any std::exception if the bytes make no sense.
  void load_state(InputArchive& archive);

 private:
  std::uint64_t pixels_;
  std::size_t replicates_;
  /// Differences between replicates that have the same expectation, pair after pair; empty until
  /// there are any.
  std::vector<float> until_now_;  ///< times the weight
  struct Stretch {
    double samples_behind;
    std::vector<float> errors;  ///< times its weight
    template <typename Archive>
    void serialize(Archive& archive) {
      archive(samples_behind, errors);
    }
  };
  std::vector<Stretch> stretches_;  ///< the last ones, the latest at the end
  double sum_ = 0.0;                ///< of shares
  std::uint64_t compared_ = 0;
};

}  // namespace ajar
