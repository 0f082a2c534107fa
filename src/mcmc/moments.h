#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ajar {

/// Sums over independent samples; summable over items (in a fixed order if the bits matter).
struct Moments {
  std::uint64_t count = 0;
  double sum = 0.0;
  double sum_of_squares = 0.0;

  void add(double x) {
    ++count;
    sum += x;
    sum_of_squares += x * x;
  }
  Moments& operator+=(const Moments& other) {
    count += other.count;
    sum += other.sum;
    sum_of_squares += other.sum_of_squares;
    return *this;
  }
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(count, sum, sum_of_squares);
  }
  /// 0 without samples.
  double mean() const { return count == 0 ? 0.0 : sum / static_cast<double>(count); }
  /// Standard error of the mean; infinite for fewer than two samples.
  double standard_error() const {
    if (count < 2) return std::numeric_limits<double>::infinity();
    const auto n = static_cast<double>(count);
    const double variance = std::max(0.0, sum_of_squares - sum * mean()) / (n - 1.0);
    return std::sqrt(variance / n);
  }
};

}  // namespace ajar
