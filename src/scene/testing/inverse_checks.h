#pragma once
#include <gtest/gtest.h>

#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/random.h"

/// Invariants of every inverse of a sampling routine (docs/methods/inverses.md).
namespace ajar::testing {

/// The uniform numbers of one sample; routines use as many as they need, from the front.
using InverseNumbers = std::array<float, 5>;

inline InverseNumbers inverse_numbers(Rng& rng) {
  InverseNumbers numbers;
  for (float& number : numbers) number = rng.next();
  return numbers;
}

/// There and back, and there again.
struct RoundTrip {
  bool inverted = false;  ///< to numbers that sample something
  InverseNumbers numbers{};
  double error = 0.0;  ///< distance of the sample by the inverse from the given one
};

struct InverseCase {
  std::string name;
  int numbers;       ///< numbers that the routine uses
  double tolerance;  ///< tolerance of the error
  /// Samples by `u`, inverts with `fresh`, samples again. Empty if `u` samples nothing.
  std::function<std::optional<RoundTrip>(const InverseNumbers& u, const InverseNumbers& fresh)>
      round_trip;
  /// The routine may have hardly anything to sample: a mirror that is seen from behind.
  bool may_be_empty = false;
};

/// χ² of two sets of counts, both of as many numbers: the probability that they differ by so much.
inline double same_counts(const std::vector<double>& a, const std::vector<double>& b) {
  double statistic = 0.0;
  int cells = 0;
  double rest_a = 0.0;
  double rest_b = 0.0;
  const auto add = [&](double x, double y) {
    statistic += (x - y) * (x - y) / (x + y);
    ++cells;
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] + b[i] >= 20.0) {
      add(a[i], b[i]);
    } else {
      rest_a += a[i];
      rest_b += b[i];
    }
  }
  if (rest_a + rest_b >= 20.0) add(rest_a, rest_b);
  if (cells == 0) return 1.0;
  const boost::math::chi_squared distribution(cells);
  return boost::math::cdf(boost::math::complement(distribution, statistic));
}

/// sample(invert(x)) is x, and invert ∘ sample of uniform numbers is uniform among the numbers that
/// sample anything, so that (invert(x), x) is distributed as (u, sample(u)). At most one trip in
/// ten thousand may fail, where roundings cross a border.
///
/// Power: each pair of numbers is counted in 12 × 12 cells, against as many numbers that were never
/// inverted. With 40,000 of either kind a density that is wrong by 12 % everywhere, or by 24 % in a
/// quarter of the cells, is found at p < 10⁻⁷.
inline void check_inverse(const InverseCase& test, int trips = 40000) {
  SCOPED_TRACE(test.name);
  constexpr int kCells = 12;
  Rng rng(1);
  Rng other(2);
  std::vector<InverseNumbers> inverses;
  std::vector<InverseNumbers> sampled;
  int failures = 0;
  double largest = 0.0;
  for (int i = 0; i < trips; ++i) {
    const InverseNumbers u = inverse_numbers(rng);
    const auto trip = test.round_trip(u, inverse_numbers(rng));
    const InverseNumbers reference = inverse_numbers(other);
    if (test.round_trip(reference, reference)) sampled.push_back(reference);
    if (!trip) continue;
    if (trip->inverted) {
      for (int k = 0; k < test.numbers; ++k) {
        const float number = trip->numbers[static_cast<std::size_t>(k)];
        ASSERT_TRUE(number >= 0.F && number < 1.F) << "number " << k << " is " << number;
      }
    }
    inverses.push_back(trip->numbers);
    largest = std::max(largest, trip->error);
    if (!trip->inverted || !(trip->error <= test.tolerance)) ++failures;
  }
  EXPECT_LE(failures, 1 + trips / 10000)
      << "of " << inverses.size() << "; largest error " << largest;
  if (!test.may_be_empty) {
    ASSERT_GT(inverses.size(), 500U) << "it hardly samples anything";
  }
  // The number of either kind is random.
  const std::size_t size = std::min(inverses.size(), sampled.size());
  for (int x = 0; x < test.numbers; ++x) {
    for (int y = 0; y < std::max(x, 1); ++y) {
      const auto counts = [&](const std::vector<InverseNumbers>& all) {
        std::vector<double> cells(kCells * kCells);
        for (std::size_t i = 0; i < size; ++i) {
          const auto cell = [&](int k) {
            return std::min(static_cast<int>(all[i][static_cast<std::size_t>(k)] * kCells),
                            kCells - 1);
          };
          cells[static_cast<std::size_t>(cell(x) * kCells + cell(y))] += 1.0;
        }
        return cells;
      };
      EXPECT_GT(same_counts(counts(inverses), counts(sampled)), 1e-7)
          << "numbers " << x << " and " << y << " are not uniform";
    }
  }
}

}  // namespace ajar::testing
