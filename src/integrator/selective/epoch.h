#pragma once
#include <cmath>
#include <cstdint>

#include "core/milestones.h"

namespace ajar {

/// Samples per pixel between two merges of seeds into the chains, and their weight in the mean of
/// the chains' picture.
///
/// Between merges, b and the seeds are as good as the samples behind them, whatever the chains do
/// with them. So an epoch weighs as much in the mean as these samples: a firefly found early would
/// otherwise count as if it were found in every epoch.
class Epoch {
 public:
  std::uint64_t begin() const { return begin_; }
  /// 0 without chains.
  std::uint64_t end() const { return end_; }
  double sample_weight() const { return sample_weight_; }
  /// Weight of the first `samples` samples, not fewer than `begin`, with the present weight from
  /// there on.
  double weight_until(std::uint64_t samples) const {
    return weight_before_ + sample_weight_ * static_cast<double>(samples - begin_);
  }

  /// Begins the next epoch at the end of this one.
  void go_on(std::uint64_t end, double sample_weight) {
    weight_before_ = weight_until(end_);
    begin_ = end_;
    end_ = end;
    sample_weight_ = sample_weight;
  }

  /// Tests whether an epoch that was read can be that of a render with so many samples.
  /// `replicates`: 0 without chains.
  bool can_be_at(std::uint64_t samples, std::uint64_t replicates) const {
    if (!(sample_weight_ >= 0.0 && std::isfinite(sample_weight_))) return false;
    if (!(weight_before_ >= 0.0 && std::isfinite(weight_before_))) return false;
    if (replicates == 0) return begin_ == 0 && end_ == 0;
    return begin_ <= samples && samples <= end_ && end_ == milestone_after(begin_, replicates);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(begin_, end_, sample_weight_, weight_before_);
  }

 private:
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;
  double sample_weight_ = 1.0;
  double weight_before_ = 0.0;  ///< weight of all epochs before
};

}  // namespace ajar
