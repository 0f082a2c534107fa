#include "integrator/montecarlo/sample_rates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "core/archive.h"
#include "image/visible_error.h"

namespace ajar {
namespace {

/// Its cells do not divide it evenly.
const Box2i kCrop(Vec2i(3, 5), Vec2i(44, 35));
constexpr int kReplicates = 4;
constexpr std::uint64_t kFirst = 8;  ///< samples after which rates change

using OfPixel = std::function<double(int x, int y)>;

std::vector<double> row_by_row(const OfPixel& value) {
  std::vector<double> values;
  for (int y = kCrop.min.y; y <= kCrop.max.y; ++y) {
    for (int x = kCrop.min.x; x <= kCrop.max.x; ++x) values.push_back(value(x, y));
  }
  return values;
}

/// Noise on the left is four times that on the right.
double two_halves(int x, int /*y*/) { return x < 24 ? 16.0 : 1.0; }

/// Distinct control variates of all pixels.
SampleRates::Guesses some_guesses() {
  SampleRates::Guesses guesses;
  for (const double value : row_by_row([](int x, int y) { return 100 * y + x; })) {
    const auto light = static_cast<float>(value);
    guesses.direct.insert(guesses.direct.end(), {light, light, light});
    guesses.indirect.insert(guesses.indirect.end(), {2.F * light, light, 0.F});
  }
  return guesses;
}

SampleRates rates_for(const OfPixel& variance) {
  SampleRates rates(kCrop, kReplicates, 7);
  rates.adjust(row_by_row(variance), some_guesses(), kFirst);
  return rates;
}

double rate_at(const SampleRates& rates, Vec2i pixel) {
  return 1.0 / static_cast<double>(rates.batch(pixel, 0, kFirst / kReplicates).weight);
}

std::uint64_t count(const SampleRates::Batch& batch) { return batch.last - batch.first; }

TEST(SampleRates, AreOneUntilNoiseIsKnown) {
  const SampleRates rates(kCrop, kReplicates, 7);
  for (std::uint64_t round = 0; round < 5; ++round) {
    const SampleRates::Batch batch = rates.batch({30, 30}, 2, round);
    EXPECT_EQ(batch.first, round);
    EXPECT_EQ(batch.last, round + 1);
    EXPECT_EQ(batch.weight, 1.F);
  }
  EXPECT_EQ(rates.light_weight(), 1.F);
}

TEST(SampleRates, FollowVisibleNoise) {
  const SampleRates rates = rates_for(two_halves);
  const double deserved = samples_for(visible_error(16.0)) / samples_for(visible_error(1.0));
  EXPECT_NEAR(rate_at(rates, {8, 20}) / rate_at(rates, {40, 20}), deserved, 1e-5);
  EXPECT_GT(deserved, 1.5);
}

TEST(SampleRates, AreOneOnAverage) {
  for (const OfPixel& variance :
       {OfPixel(two_halves), OfPixel([](int x, int y) { return x == 20 && y == 20 ? 1e9 : 1e-6; }),
        OfPixel([](int, int) { return 0.0; })}) {
    const SampleRates rates = rates_for(variance);
    double sum = 0.0;
    for (const double rate : row_by_row([&](int x, int y) { return rate_at(rates, {x, y}); })) {
      EXPECT_GT(rate, 0.1);
      EXPECT_LT(rate, 20.0);
      sum += rate;
    }
    const auto pixels = static_cast<double>(row_by_row(two_halves).size());
    EXPECT_NEAR(sum / pixels, 1.0, 1e-5);
    EXPECT_NEAR(rates.light_weight(), 1.F, 1e-5F);
  }
}

TEST(SampleRates, AccountForSamplesOfUnevenWeight) {
  // Variance after n samples of the picture: the sum of their variances over n².
  SampleRates rates = rates_for(two_halves);
  const auto later = row_by_row([&](int x, int y) {
    const auto after = static_cast<double>(4 * kFirst);
    const double until = static_cast<double>(kFirst) * two_halves(x, y);
    const double since = (after - kFirst) * two_halves(x, y) / rate_at(rates, {x, y});
    return (until + since) / (after * after);
  });
  const double before = rate_at(rates, {8, 20});
  rates.adjust(later, some_guesses(), 4 * kFirst);
  EXPECT_NEAR(1.0 / static_cast<double>(rates.batch({8, 20}, 0, kFirst).weight), before, 1e-4);
}

TEST(SampleRates, AreKeptInEachReplicateWithoutGaps) {
  SampleRates rates = rates_for(two_halves);
  for (const Vec2i& pixel : {Vec2i(8, 20), Vec2i(40, 20), Vec2i(23, 5), Vec2i(44, 35)}) {
    for (std::uint64_t replicate = 0; replicate < kReplicates; ++replicate) {
      std::uint64_t next = kFirst / kReplicates;
      SampleRates own = rates;
      for (std::uint64_t round = kFirst / kReplicates; round < 40; ++round) {
        if (round == 10)
          own.adjust(row_by_row([](int x, int) { return x; }), some_guesses(), 10 * kReplicates);
        const SampleRates::Batch batch = own.batch(pixel, replicate, round);
        EXPECT_EQ(batch.first, next);
        next = batch.last;
      }
    }
  }
}

TEST(SampleRates, HoldOnAverageAndToWithinOneSample) {
  const SampleRates rates = rates_for(two_halves);
  constexpr std::uint64_t kStart = kFirst / kReplicates;
  for (const std::uint64_t end : {kStart + 1, kStart + 2, kStart + 7}) {
    const auto rounds = static_cast<double>(end - kStart);
    double excess = 0.0;
    for (int y = kCrop.min.y; y <= kCrop.max.y; ++y) {
      for (int x = kCrop.min.x; x <= kCrop.max.x; ++x) {
        const double promised = rate_at(rates, {x, y}) * rounds;
        double of_all = 0.0;
        for (std::uint64_t replicate = 0; replicate < kReplicates; ++replicate) {
          double own = 0.0;
          for (std::uint64_t round = kStart; round < end; ++round) {
            own += static_cast<double>(count(rates.batch({x, y}, replicate, round)));
          }
          EXPECT_LT(std::abs(own - promised), 1.0);
          of_all += own;
        }
        EXPECT_LE(std::abs(of_all - kReplicates * promised), 1.0 + 1e-4);
        excess += of_all - kReplicates * promised;
      }
    }
    // One of two neighbouring whole numbers, at random: no more than 1/2 off, by a standard error.
    const auto pixels = static_cast<double>(row_by_row(two_halves).size());
    EXPECT_LT(std::abs(excess), 5.0 * 0.5 * std::sqrt(pixels));
  }
}

TEST(SampleRates, HaveAControlVariateOfEachPixel) {
  SampleRates rates = rates_for(two_halves);
  EXPECT_EQ(rates.guess({3, 5}).direct, Spectrum(503.F));
  EXPECT_EQ(rates.guess({44, 6}).indirect, Spectrum(1288.F, 644.F, 0.F));
  // A film may lack a layer.
  rates.adjust(row_by_row(two_halves), {some_guesses().direct, {}}, 2 * kFirst);
  EXPECT_EQ(rates.guess({44, 6}).direct, Spectrum(644.F));
  EXPECT_TRUE(rates.guess({44, 6}).indirect.is_black());
}

TEST(SampleRates, SurviveAnArchive) {
  SampleRates rates = rates_for(two_halves);
  const std::string bytes = archived([&](OutputArchive& out) { rates.save_state(out); });
  SampleRates again(kCrop, kReplicates, 7);
  {
    InputArchive archive(bytes);
    again.load_state(archive, kFirst);
  }
  // Rates before and after going on.
  const auto later = row_by_row([](int x, int y) { return x + 2.0 * y; });
  for (int i = 0; i < 2; ++i) {
    for (const Vec2i& pixel : {Vec2i(8, 20), Vec2i(44, 35)}) {
      for (std::uint64_t round = 5; round < 9; ++round) {
        EXPECT_EQ(again.batch(pixel, 1, round).first, rates.batch(pixel, 1, round).first);
        EXPECT_EQ(again.batch(pixel, 1, round).weight, rates.batch(pixel, 1, round).weight);
      }
      EXPECT_EQ(again.guess(pixel).indirect, rates.guess(pixel).indirect);
    }
    if (i == 0) rates.adjust(later, some_guesses(), 20);
    if (i == 0) again.adjust(later, some_guesses(), 20);
  }
  SampleRates of_another(Box2i(Vec2i(0, 0), Vec2i(3, 3)), kReplicates, 7);
  InputArchive archive(bytes);
  EXPECT_THROW(of_another.load_state(archive, kFirst), std::exception);
  InputArchive early(bytes);
  EXPECT_THROW(again.load_state(early, kFirst - 1), std::exception)
      << "adjusted after more samples than there are";
}

}  // namespace
}  // namespace ajar
