#include "integrator/selective/technique_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace ajar {
namespace {

/// A pixel on [0, 1]. Camera paths sample x evenly and bring f(x), which light paths find, too,
/// with density 2x; and g(x), which nothing else finds, so that both parts vary together.
struct ToyPixel {
  static double f(double x) { return 0.1 + x * x * x * 4.0; }
  static double g(double x) { return 0.5 + x; }
  static double light_density(double x) { return 2.0 * x; }

  /// Variance of a camera sample and squares of the light paths', with `count` of these.
  static double variance(double count) {
    constexpr int kSteps = 100000;
    double square = 0.0;
    double mean = 0.0;
    double of_light = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double x = (i + 0.5) / kSteps;
      const double value = f(x) / (1.0 + count * light_density(x));
      const double sample = value + g(x);
      mean += sample / kSteps;
      square += sample * sample / kSteps;
      of_light += count * light_density(x) * value * value / kSteps;
    }
    return square - mean * mean + of_light;
  }
};

ByTechniqueClass<double> counts_with(double light_paths) {
  ByTechniqueClass<double> counts{};
  counts[index_of(TechniqueClass::Implicit)] = 1.0;
  counts[index_of(TechniqueClass::NextEvent)] = 1.0;
  counts[index_of(TechniqueClass::Light)] = light_paths;
  return counts;
}

/// From samples with one light path each.
TechniqueErrors tried(const std::vector<double>& light_paths, int places) {
  std::vector<ByTechniqueClass<double>> counts;
  for (const double count : light_paths) counts.push_back(counts_with(count));
  TechniqueErrors errors(counts);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform;
  const auto find = [&](double x, TechniqueClass found_by) {
    const double all = 1.0 + ToyPixel::light_density(x);
    ByTechniqueClass<float> shares{};
    shares[index_of(TechniqueClass::Implicit)] = static_cast<float>(1.0 / all);
    shares[index_of(TechniqueClass::Light)] = static_cast<float>(1.0 - 1.0 / all);
    errors.add(ToyPixel::f(x) / all, found_by, shares);
  };
  ByTechniqueClass<float> by_next_event{};
  by_next_event[index_of(TechniqueClass::NextEvent)] = 1.F;
  for (int place = 0; place < places; ++place) {
    errors.begin_place();
    for (int i = 0; i < 2; ++i) {
      errors.begin_sample();
      const double x = uniform(random);
      find(x, TechniqueClass::Implicit);
      errors.add(ToyPixel::g(x), TechniqueClass::NextEvent, by_next_event);
      find(std::sqrt(uniform(random)), TechniqueClass::Light);
      errors.end_sample();
    }
    errors.end_place();
  }
  return errors;
}

TEST(TechniqueErrors, PredictVariancesWithOtherCounts) {
  const std::vector<double> counts = {0.0, 0.1, 0.33, 1.0, 4.0};
  const TechniqueErrors errors = tried(counts, 100000);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    // Their standard errors are below 0.7 %.
    EXPECT_NEAR(errors.variance(i) / ToyPixel::variance(counts[i]), 1.0, 0.03) << counts[i];
  }
}

/// The pilot's own number of places.
TEST(TechniqueErrors, FindTheLeastVarianceTimesCost) {
  std::vector<double> counts;
  for (double count = 0.0; count < 3.0; count += 0.1) counts.push_back(count);
  const TechniqueErrors errors = tried(counts, 2048);
  for (const double cost : {0.05, 0.1, 0.3, 1.0}) {
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const double of = 1.0 + cost * counts[i];
      if (errors.variance(i) * of < errors.variance(best) * (1.0 + cost * counts[best])) best = i;
      least = std::min(least, ToyPixel::variance(counts[i]) * of);
    }
    EXPECT_LT(ToyPixel::variance(counts[best]) * (1.0 + cost * counts[best]), 1.05 * least) << cost;
  }
}

/// Two connections to a light subpath y bring y and y² together, beside 0.5 + x of the camera path.
TEST(TechniqueErrors, PredictVariancesWithOtherNumbersOfLightSubpaths) {
  const std::vector<double> subpaths = {0.33, 1.0, 4.0};
  std::vector<ByTechniqueClass<double>> counts;
  for (const double n : subpaths) {
    counts.push_back(counts_with(0.0));
    counts.back()[index_of(TechniqueClass::Inner)] = n;
  }
  TechniqueErrors errors(counts);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform;
  ByTechniqueClass<float> by_next_event{};
  by_next_event[index_of(TechniqueClass::NextEvent)] = 1.F;
  ByTechniqueClass<float> by_inner{};
  by_inner[index_of(TechniqueClass::Inner)] = 1.F;
  for (int place = 0; place < 200000; ++place) {
    errors.begin_place();
    for (int i = 0; i < 2; ++i) {
      errors.begin_sample();
      errors.add(0.5 + uniform(random), TechniqueClass::NextEvent, by_next_event);
      const double y = uniform(random);
      errors.add(y, TechniqueClass::Inner, by_inner);
      errors.add(y * y, TechniqueClass::Inner, by_inner);
      errors.end_sample();
    }
  }
  // Moments of A = y + y²: E A = 5/6, E A² = 1/3 + 2/4 + 1/5. n subpaths, at random if n < 1, bring
  // A / n each.
  constexpr double kMean = 5.0 / 6.0;
  constexpr double kSquare = 1.0 / 3.0 + 2.0 / 4.0 + 1.0 / 5.0;
  for (std::size_t i = 0; i < subpaths.size(); ++i) {
    const double n = subpaths[i];
    const double of_subpaths =
        n < 1.0 ? kSquare / n - kMean * kMean : (kSquare - kMean * kMean) / n;
    // Standard errors are below 0.5 %.
    EXPECT_NEAR(errors.variance(i) / (1.0 / 12.0 + of_subpaths), 1.0, 0.02) << n;
  }
}

TEST(TechniqueErrors, AreInfiniteWhereATechniqueIsMissing) {
  TechniqueErrors errors({counts_with(0.0), counts_with(1.0)});
  ByTechniqueClass<float> by_light{};
  by_light[index_of(TechniqueClass::Light)] = 1.F;
  errors.begin_place();
  for (int i = 0; i < 2; ++i) {
    errors.begin_sample();
    errors.add(1.0, TechniqueClass::Light, by_light);
    errors.end_sample();
  }
  EXPECT_TRUE(std::isinf(errors.variance(0)));
  EXPECT_EQ(errors.variance(1), 1.0);
}

/// The sum of a camera sample's x and of the other group's: x of a group are 1/4 apart.
TEST(TechniqueErrors, SeeHowWellSamplesAreDistributed) {
  constexpr int kSamples = 4;
  TechniqueErrors errors({counts_with(0.0)});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform;
  ByTechniqueClass<float> by_next_event{};
  by_next_event[index_of(TechniqueClass::NextEvent)] = 1.F;
  for (int place = 0; place < 20000; ++place) {
    const std::array<double, 2> start = {uniform(random), uniform(random)};
    errors.begin_place();
    for (int i = 0; i < 2 * kSamples; ++i) {
      errors.begin_sample();
      const double x = std::fmod(start[static_cast<std::size_t>(i % 2)] + 0.25 * (i / 2), 1.0);
      errors.add(x, TechniqueClass::NextEvent, by_next_event);
      errors.end_sample();
    }
    errors.end_place();
  }
  // The mean of four is even in an interval of 1/4: 1/16 of the variance of a sample, times 4.
  const TechniqueErrors::Spread& spread = errors.spread_of_own(0);
  EXPECT_NEAR(spread.of_groups / spread.of_samples, 0.25, 0.01);
  EXPECT_NEAR(errors.variance(0, 0.25), 0.25 / 12.0, 0.001);
}

}  // namespace
}  // namespace ajar
