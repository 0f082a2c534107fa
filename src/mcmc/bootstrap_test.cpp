#include "mcmc/bootstrap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "core/random.h"

namespace ajar {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t sum(const std::vector<std::size_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

TEST(BootstrapMoments, MatchTheValueByHand) {
  const Moments moments = bootstrap_moments(std::vector<double>{1.0, 2.0, 6.0});
  EXPECT_DOUBLE_EQ(moments.mean(), 3.0);
  EXPECT_DOUBLE_EQ(moments.standard_error(), std::sqrt(14.0 / 6.0));
  EXPECT_EQ(bootstrap_moments({}).mean(), 0.0);
  EXPECT_EQ(bootstrap_moments(std::vector<double>{4.0}).standard_error(), kInfinity);
  EXPECT_EQ(bootstrap_moments(std::vector<double>{0.1, 0.1, 0.1}).standard_error(), 0.0);
}

TEST(ChooseSeeds, CountsAreTheExpectedOnesRoundedDownOrUp) {
  Rng rng(2);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<double> weights(50, 0.0);
    for (double& weight : weights) {
      if (rng.next() < 0.5F) weight = std::exp(20.0 * rng.next());
    }
    weights[7] = 1.0;
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    const std::size_t count = 1 + static_cast<std::size_t>(500 * rng.next());
    const auto seeds = choose_seeds(weights, count, double{rng.next()});
    ASSERT_EQ(seeds.size(), count);
    EXPECT_TRUE(std::is_sorted(seeds.begin(), seeds.end()));
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const auto times = static_cast<double>(std::count(seeds.begin(), seeds.end(), i));
      const double expected = static_cast<double>(count) * weights[i] / total;
      EXPECT_GE(times, std::floor(expected - 1e-9));
      EXPECT_LE(times, std::ceil(expected + 1e-9));
      if (weights[i] == 0.0) {
        EXPECT_EQ(times, 0.0);
      }
    }
  }
}

TEST(ChooseSeeds, ExpectedCountsAreInProportion) {
  const std::vector<double> weights{0.0, 1.0, 0.25, 3.0, 0.0, 0.75};
  constexpr int kTrials = 10000;
  std::vector<double> counts(weights.size(), 0.0);
  // Evenly spaced u integrate the counts over u up to 1/10000 per step of a count.
  for (int i = 0; i < kTrials; ++i) {
    for (const std::size_t seed : choose_seeds(weights, 7, (i + 0.5) / kTrials)) ++counts[seed];
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_NEAR(counts[i] / kTrials, 7.0 * weights[i] / 5.0, 2e-3);
  }
}

TEST(ChooseSeeds, HandlesExtremeWeights) {
  EXPECT_TRUE(choose_seeds({}, 5, 0.5).empty());
  EXPECT_TRUE(choose_seeds(std::vector<double>{0.0, 0.0}, 5, 0.5).empty());
  EXPECT_TRUE(choose_seeds(std::vector<double>{1.0}, 0, 0.5).empty());
  const std::vector<std::size_t> all_one(1000, 1);
  const double last = std::nextafter(1.0, 0.0);
  for (const double u : {0.0, 0.3, last}) {
    EXPECT_EQ(choose_seeds(std::vector<double>{0.0, 1e-300, 0.0}, 1000, u), all_one);
    EXPECT_EQ(choose_seeds(std::vector<double>{0.0, 1e308, 1e-308}, 1000, u), all_one);
    EXPECT_EQ(choose_seeds(std::vector<double>{1e308, 1e308}, 2, u),
              (std::vector<std::size_t>{0, 1}));
  }
  // Many equal weights whose sum rounds: still one seed each at most, and none beyond the end.
  EXPECT_EQ(choose_seeds(std::vector<double>(100001, 0.1), 17, last).size(), 17U);
}

TEST(ChooseSeeds, RefusesInvalidWeights) {
  for (const double bad : {kNan, kInfinity, -1.0}) {
    const std::vector<double> weights{1.0, bad};
    EXPECT_THROW(choose_seeds(weights, 1, 0.5), std::invalid_argument);
    EXPECT_THROW(apportion(weights, 1), std::invalid_argument);
    EXPECT_THROW(bootstrap_moments(weights), std::invalid_argument);
  }
  EXPECT_THROW(choose_seeds(std::vector<double>{1.0}, 1, 1.0), std::invalid_argument);
  EXPECT_THROW(choose_seeds(std::vector<double>{1.0}, 1, kNan), std::invalid_argument);
}

TEST(SeedFilter, LimitsOrDropsOutliersAndMakesUpByWeight) {
  // 99 samples of 1 and one of 101: mean 2, standard deviation 10.
  std::vector<double> weights(99, 1.0);
  weights.push_back(101.0);
  EXPECT_EQ(filter_weights(weights, SeedFilter::None, 3.0), weights);
  EXPECT_EQ(filter_weights(weights, SeedFilter::Weighted, 20.0), weights);
  const std::vector<double> limited = filter_weights(weights, SeedFilter::Weighted, 3.0);
  EXPECT_NEAR(limited[99], 32.0, 1e-9);
  EXPECT_EQ(limited[0], 1.0);
  EXPECT_EQ(filter_weights(weights, SeedFilter::Dropped, 3.0)[99], 0.0);
  EXPECT_EQ(seed_weight(weights, limited, SeedFilter::None, 99), 1.0);
  EXPECT_NEAR(seed_weight(weights, limited, SeedFilter::Weighted, 99), 101.0 / 32.0 * 131.0 / 200.0,
              1e-9);
  // On average over the chosen samples, the weight is 1.
  double mean = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    mean += limited[i] / 131.0 * seed_weight(weights, limited, SeedFilter::Weighted, i);
  }
  EXPECT_NEAR(mean, 1.0, 1e-12);
  const std::vector<double> alike = {2.0, 2.0};
  EXPECT_EQ(filter_weights(alike, SeedFilter::Dropped, 0.0), alike);
}

TEST(Apportion, GivesQuotasRoundedAndAnExactTotal) {
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(apportion(std::vector<double>{1.0, 2.0, 1.0}, 8), (Counts{2, 4, 2}));
  // Quotas 4.67, 3.33, 2: the largest remainder gets the chain that is left.
  EXPECT_EQ(apportion(std::vector<double>{7.0, 5.0, 3.0}, 10), (Counts{5, 3, 2}));
  EXPECT_EQ(apportion(std::vector<double>{1.0, 1.0, 1.0}, 4), (Counts{2, 1, 1}));
  Rng rng(6);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> b;
    std::size_t lit = 0;
    for (int k = 0; k < 20; ++k) {
      b.push_back(rng.next() < 0.2F ? 0.0 : std::exp(60.0 * (rng.next() - 0.5)));
      lit += b.back() > 0.0 ? 1 : 0;
    }
    const auto count = static_cast<std::size_t>(1000 * rng.next() * rng.next());
    const Counts counts = apportion(b, count);
    EXPECT_EQ(sum(counts), std::max(count, lit));
    for (std::size_t k = 0; k < b.size(); ++k) EXPECT_EQ(counts[k] > 0, b[k] > 0.0);
    for (std::size_t k = 0; k < b.size(); ++k) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        if (b[k] < b[j]) {
          EXPECT_LE(counts[k], counts[j]) << "more light, fewer chains";
        }
      }
    }
  }
}

TEST(Apportion, HandlesExtremeShares) {
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(apportion(std::vector<double>{0.0, 0.0}, 9), (Counts{0, 0}));
  EXPECT_EQ(apportion({}, 9), Counts{});
  EXPECT_EQ(apportion(std::vector<double>{0.0, 3.0, 0.0}, 9), (Counts{0, 9, 0}));
  EXPECT_EQ(apportion(std::vector<double>{1.0, 1e-300, 1e300}, 9), (Counts{1, 1, 7}));
  EXPECT_EQ(apportion(std::vector<double>{1e308, 1e308}, 9), (Counts{5, 4}));
  // Fewer chains than depths that have light.
  EXPECT_EQ(apportion(std::vector<double>{5.0, 0.0, 1.0, 2.0}, 2), (Counts{1, 0, 1, 1}));
  EXPECT_EQ(apportion(std::vector<double>{5.0, 0.0}, 0), (Counts{1, 0}));
}

}  // namespace
}  // namespace ajar
