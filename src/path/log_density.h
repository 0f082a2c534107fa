#pragma once
#include <algorithm>
#include <cmath>

#include "core/by_lane.h"

namespace ajar {

/// Logarithm of a density that is a product over many vertices, which no double holds. One lane,
/// any, samples the distances of all of them: the density is the mean over lanes of that by each.
class LogDensity {
 public:
  /// A factor that is the same by all lanes, by its logarithm.
  LogDensity& operator+=(double log_factor) {
    common_ += log_factor;
    return *this;
  }
  LogDensity& operator*=(double factor) {
    common_ += std::log(factor);
    return *this;
  }
  LogDensity& operator/=(double factor) {
    common_ -= std::log(factor);
    return *this;
  }
  LogDensity& operator*=(const ByLane& pdf) {
    if (pdf.x == pdf.y && pdf.x == pdf.z) return *this *= pdf.x;
    lanes_ += ByLane(std::log(pdf.x), std::log(pdf.y), std::log(pdf.z));
    return *this;
  }
  LogDensity& operator*=(const LogDensity& o) {
    common_ += o.common_;
    lanes_ += o.lanes_;
    return *this;
  }
  /// ln of it by each lane.
  ByLane by_lane() const { return lanes_ + ByLane(common_); }
  /// ln of the mean over lanes.
  double value() const {
    const double largest = std::max({lanes_.x, lanes_.y, lanes_.z});
    if (!std::isfinite(largest)) return common_ + largest;
    const ByLane log = lanes_ - ByLane(largest);
    const double others = mean(ByLane(std::exp(log.x), std::exp(log.y), std::exp(log.z)));
    return common_ + (largest + std::log(others));
  }

 private:
  double common_ = 0.0;
  ByLane lanes_{0.0};
};

}  // namespace ajar
