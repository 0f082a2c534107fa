#include "core/sobol.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "core/random.h"

namespace ajar {
namespace {

TEST(Sobol, PlainPointsAreThoseOfBoost) {
  boost::random::sobol_engine<std::uint32_t, 32> engine(kSobolDimensions);
  for (std::uint32_t n = 1; n < 5000; ++n) {
    const std::uint32_t gray = n ^ (n >> 1U);
    for (int d = 0; d < kSobolDimensions; ++d)
      ASSERT_EQ(sobol_bits(gray, d), engine()) << n << ", " << d;
  }
  // And the high bits of the index.
  for (const std::uint32_t n : {0x80000001U, 0xfffffff0U, 0x12345678U}) {
    boost::random::sobol_engine<std::uint32_t, 32> far(kSobolDimensions);
    far.discard((std::uint64_t{n} - 1) * kSobolDimensions);
    for (int d = 0; d < kSobolDimensions; ++d)
      EXPECT_EQ(sobol_bits(n ^ (n >> 1U), d), far()) << n << ", " << d;
  }
  for (int d = 0; d < kSobolDimensions; ++d) EXPECT_EQ(sobol_bits(0, d), 0U);
}

TEST(Sobol, FunctionsAgree) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Vec2 pair = sobol_2d(i, 42 + i % 3);
    ASSERT_EQ(pair.x, sobol(i, 0, 42 + i % 3));
    ASSERT_EQ(pair.y, sobol(i, 1, 42 + i % 3));
    ASSERT_EQ(pair.x, sobol_1d(i, 42 + i % 3));
  }
}

TEST(Sobol, PadsAtOnceAreTheSamePoints) {
  for (std::uint64_t n = 0; n < 100; ++n) {
    std::array<std::uint64_t, kSobolPads> seeds{};
    for (std::uint64_t k = 0; k < kSobolPads; ++k) seeds[k] = mix_bits(n) << (3 * k);
    for (const std::uint32_t index : {0U, 7U, 0xdeadbeefU}) {
      const SobolPads pads = sobol_pads(index, seeds);
      for (std::size_t k = 0; k < kSobolPads; ++k) ASSERT_EQ(pads[k], sobol_2d(index, seeds[k]));
    }
  }
}

/// True if each of the 2^k elementary intervals of every shape holds exactly one of the points.
bool is_net(const std::vector<Vec2>& points, unsigned k) {
  for (unsigned a = 0; a <= k; ++a) {
    std::set<std::uint32_t> cells;
    for (const Vec2& p : points) {
      const auto x = static_cast<std::uint32_t>(p.x * static_cast<float>(1U << a));
      const auto y = static_cast<std::uint32_t>(p.y * static_cast<float>(1U << (k - a)));
      cells.insert((y << a) + x);
    }
    if (cells.size() != points.size()) return false;
  }
  return true;
}

TEST(Sobol, AlignedBlocksAreNets) {
  for (const std::uint64_t seed : {0ULL, 1ULL, 2ULL, 77ULL, 0xffffffffffffffffULL, 1ULL << 40}) {
    for (const unsigned k : {0U, 1U, 2U, 3U, 6U, 10U}) {
      for (const std::uint32_t block : {0U, 1U, 5U}) {
        std::vector<Vec2> points;
        for (std::uint32_t i = 0; i < (1U << k); ++i)
          points.push_back(sobol_2d((block << k) + i, seed));
        EXPECT_TRUE(is_net(points, k))
            << "seed " << seed << ", 2^" << k << " points, block " << block;
      }
    }
  }
}

TEST(Sobol, EveryDimensionIsStratified) {
  for (const std::uint64_t seed : {3ULL, 4ULL}) {
    for (int d = 0; d < kSobolDimensions; ++d) {
      std::set<int> cells;
      for (std::uint32_t i = 0; i < 1024; ++i) {
        const float x = sobol(i, d, seed);
        ASSERT_TRUE(x >= 0.F && x < 1.F);
        cells.insert(static_cast<int>(x * 1024.F));
      }
      EXPECT_EQ(cells.size(), 1024U) << d;
    }
  }
}

TEST(Sobol, EachPointAloneIsUniformOverSeeds) {
  // χ² on 16 × 16 cells, 255 degrees of freedom: mean 255, σ 22.6; p = 1e-6 near 378.
  for (const std::uint32_t index : {0U, 1U, 2U, 1000U, 0xffffffffU}) {
    std::array<int, 256> counts{};
    constexpr int kSeeds = 51200;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Vec2 p = sobol_2d(index, seed);
      ++counts[static_cast<std::size_t>(p.y * 16.F) * 16 + static_cast<std::size_t>(p.x * 16.F)];
    }
    double chi_square = 0.0;
    for (const int c : counts) chi_square += (c - 200.0) * (c - 200.0) / 200.0;
    EXPECT_LT(chi_square, 378.0) << index;
    EXPECT_GT(chi_square, 155.0) << index;
  }
}

/// Correlation of point i of one sequence with the partner's over many sequences and points.
template <typename Pair>
double correlation(int sequences, std::uint32_t points, Pair pair) {
  double xy = 0.0;
  for (int s = 0; s < sequences; ++s) {
    for (std::uint32_t i = 0; i < points; ++i) {
      const Vec2 p = pair(static_cast<std::uint64_t>(s), i);
      xy += (p.x - 0.5) * (p.y - 0.5);
    }
  }
  return 12.0 * xy / sequences / points;
}

TEST(Sobol, SequencesOfDifferentSeedsAreUncorrelated) {
  // Products of independent uniforms have unit variance after scaling. Nested shuffling raises the
  // variance of the mean by up to 1.3, since it moves pairs of points together.
  constexpr int kSequences = 4000;
  constexpr std::uint32_t kPoints = 64;
  const double sigma = std::sqrt(1.3 / (kSequences * kPoints));
  for (const std::uint64_t step : {1ULL, 2ULL, 16ULL, 65536ULL, 1ULL << 32}) {
    for (const int dimension : {0, 1}) {
      const double r = correlation(kSequences, kPoints, [&](std::uint64_t s, std::uint32_t i) {
        return Vec2(sobol(i, dimension, s), sobol(i, dimension, s + step));
      });
      EXPECT_LT(std::abs(r), 5 * sigma) << "step " << step << ", dimension " << dimension;
    }
  }
  for (const int other : {1, 2, 3}) {
    const double r = correlation(kSequences, kPoints, [&](std::uint64_t s, std::uint32_t i) {
      return Vec2(sobol(i, 0, s), sobol(i, other, s));
    });
    EXPECT_LT(std::abs(r), 5 * sigma) << "dimensions 0 and " << other;
  }
}

TEST(Sobol, FirstPointsOfNeighbouringSeedsShowNoPattern) {
  // Pairs (seed, seed + 1) fill the square: χ² with 255 degrees of freedom as above.
  for (const std::uint64_t step : {1ULL, 2ULL, 256ULL}) {
    std::array<int, 256> counts{};
    for (std::uint64_t seed = 0; seed < 51200; ++seed) {
      const auto x = static_cast<std::size_t>(sobol_1d(0, seed) * 16.F);
      const auto y = static_cast<std::size_t>(sobol_1d(0, seed + step) * 16.F);
      ++counts[y * 16 + x];
    }
    double chi_square = 0.0;
    for (const int c : counts) chi_square += (c - 200.0) * (c - 200.0) / 200.0;
    EXPECT_LT(chi_square, 378.0) << step;
  }
}

TEST(Sobol, PadsTogetherAreUniformInFourDimensions) {
  // Two pads of one sample index: 4^4 cells. The strata of each pad make the counts of one sequence
  // smoother than chance, but not the joint ones over many sequences.
  std::array<int, 256> counts{};
  for (std::uint64_t s = 0; s < 3200; ++s) {
    for (std::uint32_t i = 0; i < 16; ++i) {
      const Vec2 a = sobol_2d(i, 2 * s);
      const Vec2 b = sobol_2d(i, 2 * s + 1);
      const auto cell = [](float v) { return static_cast<std::size_t>(v * 4.F); };
      ++counts[((cell(a.x) * 4 + cell(a.y)) * 4 + cell(b.x)) * 4 + cell(b.y)];
    }
  }
  double chi_square = 0.0;
  for (const int c : counts) chi_square += (c - 200.0) * (c - 200.0) / 200.0;
  // The marginals of each pad are exact, which leaves 15² = 225 degrees of freedom.
  EXPECT_LT(chi_square, 345.0);
  EXPECT_GT(chi_square, 130.0);
}

/// Root mean square error over seeds of the mean of f over the first n points.
template <typename Sampler>
double integration_error(std::uint32_t n, Sampler sampler, double* bias = nullptr) {
  const auto f = [](const Vec2& p) { return std::exp(p.x) * std::sin(2.0 * p.y); };
  const double exact = (std::exp(1.0) - 1.0) * (1.0 - std::cos(2.0)) / 2.0;
  constexpr int kSeeds = 500;
  double squares = 0.0;
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    double mean = 0.0;
    for (std::uint32_t i = 0; i < n; ++i) mean += f(sampler(i, seed)) / n;
    squares += (mean - exact) * (mean - exact);
    sum += mean - exact;
  }
  const double error = std::sqrt(squares / kSeeds);
  if (bias != nullptr) *bias = sum / kSeeds / (error / std::sqrt(kSeeds));
  return error;
}

TEST(Sobol, IntegratesSmoothFunctionsWithoutBiasAtOrderThreeHalves) {
  const auto points = [](std::uint32_t i, std::uint64_t seed) { return sobol_2d(i, seed); };
  double bias = 0.0;
  const double coarse = integration_error(16, points, &bias);
  EXPECT_LT(std::abs(bias), 5.0) << "in standard errors";
  const double fine = integration_error(1024, points, &bias);
  EXPECT_LT(std::abs(bias), 5.0) << "in standard errors";
  const double slope = std::log2(fine / coarse) / 6.0;
  EXPECT_LT(slope, -1.35);
  EXPECT_GT(slope, -1.65);

  const auto independent = [](std::uint32_t i, std::uint64_t seed) {
    return Vec2(to_unit_float(static_cast<std::uint32_t>(hash_numbers(seed, i, 0))),
                to_unit_float(static_cast<std::uint32_t>(hash_numbers(seed, i, 1))));
  };
  const double random_slope =
      std::log2(integration_error(1024, independent) / integration_error(16, independent)) / 6.0;
  EXPECT_NEAR(random_slope, -0.5, 0.05);
  EXPECT_GT(integration_error(1024, independent) / fine, 30.0);
}

}  // namespace
}  // namespace ajar
