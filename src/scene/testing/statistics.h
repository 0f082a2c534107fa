#pragma once
#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

/// Statistics for tests of sampling code.
namespace ajar::testing {

/// Running mean of independent samples.
class Mean {
 public:
  void add(double x) {
    sum_ += x;
    squares_ += x * x;
    ++count_;
  }
  double value() const { return sum_ / static_cast<double>(count_); }
  /// Standard error of the mean.
  double error() const {
    const auto n = static_cast<double>(count_);
    return std::sqrt(std::max(0.0, squares_ / n - value() * value()) / n);
  }

 private:
  double sum_ = 0.0;
  double squares_ = 0.0;
  std::size_t count_ = 0;
};

/// Within five standard errors, plus `tolerance` of `expected` for rounding. Fails if the mean is
/// known worse than to `power` of `expected`: such a test could not fail for a reason.
inline void expect_mean(const Mean& mean, double expected, double power = 0.02,
                        double tolerance = 1e-4) {
  EXPECT_NEAR(mean.value(), expected, 5.0 * mean.error() + tolerance * std::abs(expected));
  EXPECT_LE(5.0 * mean.error(), power * std::abs(expected)) << "too few samples to tell";
}
inline void expect_same_mean(const Mean& a, const Mean& b, double power = 0.03) {
  const double error = std::hypot(a.error(), b.error());
  EXPECT_NEAR(a.value(), b.value(), 5.0 * error + 1e-4 * std::abs(a.value()));
  EXPECT_LE(5.0 * error, power * std::abs(a.value())) << "too few samples to tell";
}

/// Chi-square goodness of fit; cells that expect fewer than 10 are put together. Fails below p =
/// 1e-6.
inline void expect_fits(std::span<const double> counts, std::span<const double> expected) {
  double statistic = 0.0;
  double pooled_count = 0.0;
  double pooled_expected = 0.0;
  int cells = 0;
  const auto add = [&](double count, double mean) {
    statistic += (count - mean) * (count - mean) / mean;
    ++cells;
  };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (expected[i] >= 10.0) {
      add(counts[i], expected[i]);
    } else {
      pooled_count += counts[i];
      pooled_expected += expected[i];
    }
  }
  if (pooled_expected >= 10.0) {
    add(pooled_count, pooled_expected);
  } else {
    EXPECT_LE(pooled_count, 40.0) << "samples where the density says there are none";
  }
  ASSERT_GT(cells, 3) << "too few cells to tell";
  // The counts include samples that carried nothing, so no degree of freedom is lost.
  const boost::math::chi_squared distribution(cells);
  EXPECT_GT(boost::math::cdf(boost::math::complement(distribution, statistic)), 1e-6)
      << "chi-square " << statistic << " over " << cells << " cells";
}

}  // namespace ajar::testing
