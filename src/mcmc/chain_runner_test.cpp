#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "mcmc/bootstrap.h"
#include "mcmc/primary/gaussian_mutation.h"
#include "mcmc/primary/kelemen_mutation.h"
#include "mcmc/primary/primary_runner.h"
#include "mcmc/testing/toy_target.h"
#include "scene/testing/statistics.h"

namespace ajar {
namespace {

using testing::Histogram;
using testing::kToyShape;
using testing::Toy;
using testing::ToyTarget;
using testing::ToyValue;

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Each chain's deposits are one independent estimate of every bin, unbiased since the chain starts
/// in its target's distribution. `power`: how well each bin is known, relative to it.
void expect_unbiased(const Toy& toy, const PrimarySettings& settings, std::uint64_t chains,
                     std::uint64_t steps, bool combined, double power) {
  const GaussianMutation mutation(0.03);
  ToyTarget target(toy.function);
  PrimaryRunner runner(settings, mutation, kToyShape, target);
  std::vector<testing::Mean> means(toy.fractions.size());
  for (std::uint64_t i = 0; i < chains; ++i) {
    PrimaryChain chain = testing::exact_start(toy, 21, i);
    Histogram histogram(toy.fractions.size());
    runner.run(chain, steps, histogram, combined ? std::optional(toy.mean) : std::nullopt);
    for (std::size_t k = 0; k < means.size(); ++k) {
      means[k].add(histogram.sums()[k] / static_cast<double>(steps));
    }
  }
  for (std::size_t k = 0; k < means.size(); ++k) {
    SCOPED_TRACE(std::string(toy.name) + ", bin " + std::to_string(k));
    testing::expect_mean(means[k], toy.fractions[k], power);
  }
}

TEST(ChainRunner, ExpectedValuesAreUnbiased) {
  PrimarySettings settings;
  settings.probabilities = {0.3, 0.2, 0.2};
  for (const Toy& toy : {testing::step(), testing::product(), testing::variable_dimension()}) {
    expect_unbiased(toy, settings, 20000, 40, false, 0.25);
  }
}

TEST(ChainRunner, CombinationWithLargeStepsIsUnbiased) {
  PrimarySettings settings;
  for (const double large : {0.1, 0.5}) {
    settings.probabilities.large = large;
    for (const Toy& toy : {testing::step(), testing::product(), testing::variable_dimension()}) {
      expect_unbiased(toy, settings, 20000, 40, true, 0.25);
    }
  }
}

TEST(ChainRunner, SeveralTriesAreUnbiased) {
  PrimarySettings settings;
  settings.probabilities = {0.3, 0.2, 0.2};
  settings.tries = 4;
  for (const bool combined : {false, true}) {
    for (const Toy& toy : {testing::step(), testing::product(), testing::variable_dimension()}) {
      expect_unbiased(toy, settings, 20000, 20, combined, 0.25);
    }
  }
}

TEST(ChainRunner, SeveralTriesMoveTheChainMoreOften) {
  const GaussianMutation mutation(0.2);
  const Toy toy = testing::peak();
  ToyTarget target(toy.function);
  double acceptance[2] = {0.0, 0.0};
  for (const int tries : {1, 8}) {
    PrimarySettings settings;
    settings.tries = tries;
    PrimaryRunner runner(settings, mutation, kToyShape, target);
    PrimaryChain chain = testing::exact_start(toy, 23, 0);
    Histogram histogram(toy.fractions.size());
    const ChainStatistics statistics = runner.run(chain, 20000, histogram);
    for (const auto& kind : statistics.moves) acceptance[tries > 1 ? 1 : 0] += kind.acceptances;
  }
  EXPECT_GT(acceptance[1], 2.0 * acceptance[0]);
}

TEST(ChainRunner, CombinationWithLargeStepsHelpsDimBins) {
  const GaussianMutation mutation(0.03);
  const Toy toy = testing::step();
  ToyTarget target(toy.function);
  PrimarySettings settings;
  settings.probabilities.large = 0.5;
  PrimaryRunner runner(settings, mutation, kToyShape, target);
  testing::Mean dimmest[2];
  for (const bool combined : {false, true}) {
    for (std::uint64_t i = 0; i < 5000; ++i) {
      PrimaryChain chain = testing::exact_start(toy, 22, i);
      Histogram histogram(toy.fractions.size());
      runner.run(chain, 40, histogram, combined ? std::optional(toy.mean) : std::nullopt);
      dimmest[combined ? 1 : 0].add(histogram.sums().back());
    }
  }
  EXPECT_LT(dimmest[1].error(), 0.8 * dimmest[0].error());
}

TEST(ChainRunner, SeedsFromABootstrapMakeShortChainsUnbiased) {
  // The whole way: few bootstrap samples, resampled, chains much too short to forget their start.
  // 3000 replicates; the mean of each bin is known to about 1 %.
  const KelemenMutation mutation;
  const Toy toy = testing::product();
  ToyTarget target(toy.function);
  PrimaryRunner runner({}, mutation, kToyShape, target);
  std::vector<testing::Mean> means(toy.fractions.size());
  for (std::uint64_t replicate = 0; replicate < 3000; ++replicate) {
    std::vector<double> weights;
    for (std::uint64_t i = 0; i < 50; ++i) {
      BootstrapSource source(replicate, i);
      weights.push_back(toy.function(source).scalar);
    }
    const double b = bootstrap_moments(weights).mean();
    const std::vector<std::size_t> seeds =
        choose_seeds(weights, 10, to_unit_double(hash_numbers(replicate, 1, 1)));
    Histogram histogram(toy.fractions.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      PrimaryChain chain(kToyShape, hash_numbers(replicate, i, 2),
                         bootstrap_key(replicate, seeds[i]), weights[seeds[i]]);
      runner.run(chain, 5, histogram);
    }
    for (std::size_t k = 0; k < means.size(); ++k) means[k].add(b * histogram.sums()[k] / 50.0);
  }
  for (std::size_t k = 0; k < means.size(); ++k) {
    SCOPED_TRACE(k);
    testing::expect_mean(means[k], toy.mean * toy.fractions[k], 0.5);
  }
}

TEST(ChainRunner, WeightsAddUpToTheNumberOfSteps) {
  const KelemenMutation mutation;
  for (const Toy& toy : testing::toys()) {
    ToyTarget target(toy.function);
    PrimaryRunner runner({}, mutation, kToyShape, target);
    PrimaryChain chain = testing::exact_start(toy, 3, 1);
    Histogram histogram(toy.fractions.size());
    const ChainStatistics statistics = runner.run(chain, 1000, histogram);
    EXPECT_NEAR(sum(histogram.sums()), 1000.0, 1e-3);
    EXPECT_EQ(statistics.steps, 1000U);
    EXPECT_EQ(chain.step, 1000U);
    const std::uint64_t large = statistics.moves[move_of(StepKind::Large)].proposals;
    EXPECT_NEAR(static_cast<double>(large), 300.0, 5.0 * 14.5);
  }
}

TEST(ChainRunner, ARunCutInPiecesIsTheSameChain) {
  const KelemenMutation mutation;
  PrimarySettings settings;
  settings.probabilities = {0.2, 0.3, 0.3};
  for (const Toy& toy : testing::toys()) {
    ToyTarget target(toy.function);
    PrimaryRunner runner(settings, mutation, kToyShape, target);
    PrimaryRunner other_runner(settings, mutation, kToyShape, target);
    PrimaryChain whole = testing::exact_start(toy, 3, 2);
    PrimaryChain pieces = whole;
    Histogram histogram(toy.fractions.size());
    Histogram of_pieces(toy.fractions.size());
    const ChainStatistics statistics = runner.run(whole, 600, histogram);
    ChainStatistics added;
    for (const std::uint64_t steps : {0U, 1U, 99U, 500U}) {
      added += (steps % 2 == 0 ? runner : other_runner).run(pieces, steps, of_pieces);
    }
    EXPECT_EQ(pieces.scalar, whole.scalar);
    EXPECT_EQ(pieces.streak, whole.streak);
    EXPECT_EQ(added.longest_streak, statistics.longest_streak);
    EXPECT_EQ(added.zero, statistics.zero);
    for (std::size_t k = 0; k < toy.fractions.size(); ++k) {
      EXPECT_NEAR(of_pieces.sums()[k], histogram.sums()[k], 1e-4 * (1.0 + histogram.sums()[k]));
    }
  }
}

TEST(ChainRunner, LongestStreakContinuesAcrossRuns) {
  // A state that nothing can leave.
  ToyTarget target([](SampleSource& numbers) {
    BootstrapSource start(1, 1);
    const bool same = numbers.get(testing::kCameraX) == start.get(testing::kCameraX);
    return ToyValue{same ? 1.0 : 0.0, 0};
  });
  const KelemenMutation mutation;
  PrimaryRunner runner({}, mutation, kToyShape, target);
  PrimaryChain chain(kToyShape, 5, bootstrap_key(1, 1), 1.0);
  Histogram histogram(1);
  ChainStatistics statistics = runner.run(chain, 30, histogram);
  statistics += runner.run(chain, 20, histogram);
  EXPECT_EQ(statistics.longest_streak, 50U);
  EXPECT_EQ(statistics.zero, 50U);
  EXPECT_EQ(histogram.sums()[0], 50.0);
}

TEST(ChainRunner, RefusesANondeterministicTarget) {
  int calls = 0;
  ToyTarget target([&calls](SampleSource& numbers) {
    return ToyValue{1.0 + double{numbers.get(testing::kCameraX)} + 1e-15 * ++calls, 0};
  });
  const KelemenMutation mutation;
  PrimaryRunner runner({}, mutation, kToyShape, target);
  BootstrapSource start(1, 1);
  SplatBuffer splats;
  PrimaryChain chain(kToyShape, 123, bootstrap_key(1, 1), target.evaluate(start, {}, splats));
  Histogram histogram(1);
  try {
    runner.run(chain, 10, histogram);
    FAIL() << "no exception";
  } catch (const std::logic_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind("bug: ", 0), 0U) << message;
    EXPECT_NE(message.find("seed 123"), std::string::npos) << message;
    EXPECT_NE(message.find("0 steps"), std::string::npos) << message;
  }
}

TEST(ChainRunner, RefusesAStartWithoutLight) {
  const KelemenMutation mutation;
  Histogram histogram(1);
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    ToyTarget target([bad](SampleSource&) { return ToyValue{bad, 0}; });
    PrimaryRunner runner({}, mutation, kToyShape, target);
    PrimaryChain chain(kToyShape, 1, 1, bad);
    EXPECT_THROW(runner.run(chain, 1, histogram), std::logic_error);
  }
}

TEST(ChainRunner, CountsDiscardedProposalsAndNeverAcceptsThem) {
  const double values[] = {std::nan(""), std::numeric_limits<double>::infinity(), -1.0, 0.0,
                           1e-310};
  ToyTarget target([&values](SampleSource& numbers) {
    const float u = numbers.get(testing::kCameraX);
    if (u < 0.5F) return ToyValue{1.0, 0};
    return ToyValue{values[testing::bin_of(2.F * u - 1.F, 5)], 1};
  });
  std::uint64_t index = 0;
  while (BootstrapSource(1, index).get(testing::kCameraX) >= 0.5F) ++index;
  const KelemenMutation mutation;
  PrimarySettings settings;
  settings.probabilities.large = 1.0;
  PrimaryRunner runner(settings, mutation, kToyShape, target);
  for (const bool combined : {false, true}) {
    PrimaryChain chain(kToyShape, 17, bootstrap_key(1, index), 1.0);
    Histogram histogram(2);
    const ChainStatistics statistics =
        runner.run(chain, 10000, histogram, combined ? std::optional(0.5) : std::nullopt);
    // Each a tenth of the proposals: 1000 ± 5 · 30.
    EXPECT_NEAR(static_cast<double>(statistics.discarded_nan), 1000.0, 150.0);
    EXPECT_NEAR(static_cast<double>(statistics.discarded_infinite), 1000.0, 150.0);
    EXPECT_NEAR(static_cast<double>(statistics.discarded_negative), 1000.0, 150.0);
    EXPECT_NEAR(static_cast<double>(statistics.zero), 2000.0, 5.0 * 40.0);
    MoveRecord all;
    for (const MoveRecord& move : statistics.moves) all += move;
    EXPECT_EQ(all.dark, statistics.zero + statistics.discarded_nan + statistics.discarded_infinite +
                            statistics.discarded_negative);
    ASSERT_TRUE(statistics.first_discarded);
    EXPECT_EQ(statistics.first_discarded->seed, 17U);
    EXPECT_LT(statistics.first_discarded->step, 100U);
    EXPECT_EQ(histogram.sums()[1], 0.0);
  }
}

TEST(ChainRunner, RefusesACombinationWithoutB) {
  const KelemenMutation mutation;
  const Toy toy = testing::step();
  ToyTarget target(toy.function);
  PrimaryRunner runner({}, mutation, kToyShape, target);
  PrimaryChain chain = testing::exact_start(toy, 3, 1);
  Histogram histogram(36);
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(runner.run(chain, 1, histogram, bad), std::invalid_argument);
  }
}

TEST(ChainRunner, RefusesSettingsThatMakeNoSteps) {
  const KelemenMutation mutation;
  ToyTarget target(testing::step().function);
  PrimarySettings settings;
  settings.probabilities.large = 1.5;
  EXPECT_THROW(PrimaryRunner(settings, mutation, kToyShape, target), std::invalid_argument);
  settings = {};
  for (const float bad : {-1.F, 65.F, std::nanf("")}) {
    settings.sizes.connection[2] = bad;
    EXPECT_THROW(PrimaryRunner(settings, mutation, kToyShape, target), std::invalid_argument);
  }
}

/// A product of two halves that keeps each half's factor as long as the half has not changed.
class CachingTarget final : public Target {
 public:
  explicit CachingTarget(bool caching) : caching_(caching) {}
  double evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) override {
    proposed_ = current_;
    if (change.camera || !caching_) {
      proposed_[0] = factor(numbers.get(testing::kCameraX)) * factor(numbers.get(testing::kInner));
      ++computed_;
    }
    if (change.light || !caching_) {
      proposed_[1] =
          factor(numbers.get(testing::kLight)) * factor(numbers.get(testing::kInnerLight));
      ++computed_;
    }
    const double scalar = proposed_[0] * proposed_[1] * factor(numbers.get(testing::kChoice));
    splats.push_back({Vec2(0.F, 0.F), scalar > 1.0 ? 1 : 0, Spectrum(static_cast<float>(scalar))});
    return scalar;
  }
  void accepted() override { current_ = proposed_; }
  int computed() const { return computed_; }

 private:
  static double factor(float u) { return 1.0 + 0.9 * std::cos(2.0 * double{kPi} * double{u}); }
  bool caching_;
  int computed_ = 0;
  std::array<double, 2> current_{};
  std::array<double, 2> proposed_{};
};

TEST(ChainRunner, TargetsMayReuseTheUnchangedHalf) {
  const KelemenMutation mutation;
  PrimarySettings settings;
  settings.probabilities = {0.1, 0.45, 0.45};
  CachingTarget caching(true);
  CachingTarget plain(false);
  PrimaryRunner with_cache(settings, mutation, kToyShape, caching);
  PrimaryRunner without(settings, mutation, kToyShape, plain);
  // Two chains take turns: a run must not see what the other chain left in the cache.
  for (const std::uint64_t index : {1U, 2U, 1U, 2U}) {
    SplatBuffer splats;
    BootstrapSource start(4, index);
    const double scalar = CachingTarget(false).evaluate(start, {}, splats);
    PrimaryChain a(kToyShape, index, bootstrap_key(4, index), scalar);
    PrimaryChain b = a;
    Histogram of_a(2);
    Histogram of_b(2);
    with_cache.run(a, 2000, of_a);
    without.run(b, 2000, of_b);
    EXPECT_EQ(a.scalar, b.scalar);
    EXPECT_EQ(of_a.sums(), of_b.sums());
  }
  EXPECT_LT(caching.computed(), 0.65 * plain.computed());
}

/// The light of the brightest bins of a peak by chains whose seeds come from a filter, relative to
/// the truth.
testing::Mean filtered_brightness(SeedFilter filter, std::uint64_t steps) {
  const GaussianMutation mutation(0.03);
  const Toy toy = testing::peak();
  ToyTarget target(toy.function);
  PrimaryRunner runner({}, mutation, kToyShape, target);
  const double truth = (toy.fractions.front() + toy.fractions.back()) * toy.mean;
  testing::Mean mean;
  for (std::uint64_t replicate = 0; replicate < 4000; ++replicate) {
    std::vector<double> weights;
    for (std::uint64_t i = 0; i < 100; ++i) {
      BootstrapSource source(replicate, i);
      weights.push_back(toy.function(source).scalar);
    }
    const double b = bootstrap_moments(weights).mean();
    const std::vector<double> filtered = filter_weights(weights, filter, 3.0);
    double sum = 0.0;
    const std::vector<std::size_t> seeds =
        choose_seeds(filtered, 4, to_unit_double(hash_numbers(replicate, 1, 1)));
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      PrimaryChain chain(kToyShape, hash_numbers(replicate, i, 2),
                         bootstrap_key(replicate, seeds[i]), weights[seeds[i]]);
      Histogram histogram(toy.fractions.size());
      runner.run(chain, steps, histogram);
      sum += seed_weight(weights, filtered, filter, seeds[i]) *
             (histogram.sums().front() + histogram.sums().back());
    }
    mean.add(b * sum / (4.0 * static_cast<double>(steps)) / truth);
  }
  return mean;
}

TEST(ChainRunner, FilteredSeedsAreUnbiasedWithWeightsOnly) {
  for (const std::uint64_t steps : {2, 20}) {
    testing::expect_mean(filtered_brightness(SeedFilter::Weighted, steps), 1.0, 0.05);
  }
  // The figures of docs/notebook/mutations.md: lost light comes back as chains forget their start.
  const testing::Mean after_two = filtered_brightness(SeedFilter::Dropped, 2);
  const testing::Mean after_twenty = filtered_brightness(SeedFilter::Dropped, 20);
  EXPECT_NEAR(after_two.value(), 0.613, 5.0 * after_two.error());
  EXPECT_NEAR(after_twenty.value(), 0.899, 5.0 * after_twenty.error());
  EXPECT_LT(after_twenty.value() + 5.0 * after_twenty.error(), 1.0);
}

}  // namespace
}  // namespace ajar
