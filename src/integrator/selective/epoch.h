#pragma once
#include <cmath>
#include <cstdint>

#include "core/milestones.h"

namespace ajar {

/// The samples per pixel between two joins of recruits, and what they weigh in the mean of what
/// chains make; where there are no recruits, all of them, with a weight of one.
///
/// Between joins, b and the seeds are as good as the samples behind them, whatever the chains do
/// with them. So what a stretch adds to the mean weighs as much as these samples: a firefly found
/// early would otherwise count as if it were found in every stretch.
class Epoch {
 public:
  std::uint64_t begin() const { return begin_; }
  /// 0 where there are no recruits.
  std::uint64_t end() const { return end_; }
  double sample_weight() const { return sample_weight_; }
  /// Weight of the first `samples` samples, not fewer than `begin`, with the present weight from
  /// there on.
  double weight_until(std::uint64_t samples) const {
    return weight_before_ + sample_weight_ * static_cast<double>(samples - begin_);
  }

  /// The next stretch, from the end of this one.
  void go_on(std::uint64_t end, double sample_weight) {
    weight_before_ = weight_until(end_);
    begin_ = end_;
    end_ = end;
    sample_weight_ = sample_weight;
  }

  /// For what is read from an archive: whether it can be the stretch of a render with so many
  /// samples. `replicates`: 0 where there are no recruits.
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
