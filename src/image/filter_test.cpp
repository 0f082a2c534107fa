#include "image/filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/random.h"

namespace ajar {
namespace {

struct NamedFilter {
  std::string name;
  Filter filter;
};

std::vector<NamedFilter> all_filters() {
  return {{"box", Filter::box()},
          {"box wide", Filter::box({1.3F, 0.7F})},
          {"triangle", Filter::triangle({2.F, 1.5F})},
          {"gaussian", Filter::gaussian({2.F, 1.5F}, 2.F)},
          {"gaussian sharp", Filter::gaussian({2.F, 2.F}, 10.F)},
          {"mitchell", Filter::mitchell({2.F, 3.F}, 1.F / 3, 1.F / 3)},
          {"mitchell sharp", Filter::mitchell({2.F, 2.F}, 0.F, 0.75F)},
          {"sinc", Filter::sinc({4.F, 4.F}, 3.F)},
          {"sinc cut", Filter::sinc({2.5F, 3.5F}, 3.F)}};
}

/// ∫ h g over the support, by midpoints.
double integrate(const Filter& filter, const std::function<double(double, double)>& g) {
  constexpr int kSteps = 1024;
  const Vec2 r = filter.radius();
  double sum = 0.0;
  for (int j = 0; j < kSteps; ++j) {
    const double y = r.y * (2.0 * (j + 0.5) / kSteps - 1.0);
    for (int i = 0; i < kSteps; ++i) {
      const double x = r.x * (2.0 * (i + 0.5) / kSteps - 1.0);
      sum += filter.eval({static_cast<float>(x), static_cast<float>(y)}) * g(x, y);
    }
  }
  return sum * 4.0 * r.x * r.y / kSteps / kSteps;
}

TEST(Filter, IntegratesToOne) {
  for (const auto& [name, filter] : all_filters()) {
    EXPECT_NEAR(integrate(filter, [](double, double) { return 1.0; }), 1.0, 2e-5) << name;
  }
}

TEST(Filter, HasTheShapesOfPbrt) {
  // Ratios h(x)/h(0), from the formulas written out by hand.
  const auto ratio = [](const Filter& f, float x) { return f.eval({x, 0.F}) / f.eval({0.F, 0.F}); };
  EXPECT_NEAR(ratio(Filter::triangle({2.F, 2.F}), 0.5F), 0.75, 1e-6);
  EXPECT_NEAR(ratio(Filter::gaussian({2.F, 2.F}, 2.F), 1.F),
              (std::exp(-2.0) - std::exp(-8.0)) / (1.0 - std::exp(-8.0)), 1e-6);
  // Mitchell with B = C = 1/3, radius 2, at x = 1: B/6 against (6 − 2B)/6 at 0.
  EXPECT_NEAR(ratio(Filter::mitchell({2.F, 2.F}, 1.F / 3, 1.F / 3), 1.F), (1.0 / 18) / (16.0 / 18),
              1e-6);
  // sinc(1.5) · sinc(0.5) = −2/(3π) · 2/π.
  EXPECT_NEAR(ratio(Filter::sinc({4.F, 4.F}, 3.F), 1.5F), -4.0 / (3.0 * M_PI * M_PI), 1e-6);
}

TEST(Filter, SupportIsOpenToTheRight) {
  const Filter box = Filter::box();
  EXPECT_EQ(box.eval({-0.5F, -0.5F}), 1.F);
  EXPECT_EQ(box.eval({0.5F, 0.F}), 0.F);
  EXPECT_EQ(box.eval({0.F, 0.5F}), 0.F);
  EXPECT_EQ(box.eval({std::numeric_limits<float>::quiet_NaN(), 0.F}), 0.F);
}

TEST(Filter, SamplesAreUnbiasedForEveryIntegrand) {
  // Functions that are not symmetric, oscillate, or live at the border.
  const std::vector<std::function<double(double, double)>> integrands = {
      [](double, double) { return 1.0; }, [](double x, double y) { return x + 0.3 * y * y; },
      [](double x, double y) { return std::cos(5.0 * x + 0.3) * std::exp(0.7 * y); },
      [](double x, double y) { return std::abs(x) > 1.2 || std::abs(y) > 1.2 ? 1.0 : 0.0; }};
  for (const auto& [name, filter] : all_filters()) {
    for (std::size_t k = 0; k < integrands.size(); ++k) {
      Rng rng(17, k);
      constexpr int kSamples = 200000;
      double sum = 0.0;
      double squares = 0.0;
      for (int i = 0; i < kSamples; ++i) {
        const float u = rng.next();
        const FilterSample s = filter.sample({u, rng.next()});
        const double value = s.weight * integrands[k](s.offset.x, s.offset.y);
        sum += value;
        squares += value * value;
      }
      const double mean = sum / kSamples;
      const double error = std::sqrt(std::max(squares / kSamples - mean * mean, 0.0) / kSamples);
      EXPECT_NEAR(mean, integrate(filter, integrands[k]), 5.0 * error + 3e-5)
          << name << ", integrand " << k;
    }
  }
}

TEST(Filter, SampleWeightsHardlyVary) {
  for (const auto& [name, filter] : all_filters()) {
    Rng rng(3);
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kSamples = 100000;
    for (int i = 0; i < kSamples; ++i) {
      const float u = rng.next();
      const double w = std::abs(filter.sample({u, rng.next()}).weight);
      EXPECT_LT(w, 2.5) << name;
      sum += w;
      squares += w * w;
    }
    const double mean = sum / kSamples;
    EXPECT_LT(std::sqrt(squares / kSamples - mean * mean) / mean, 0.03) << name;
  }
}

TEST(Filter, SamplingIsMonotoneAndStaysInside) {
  for (const auto& [name, filter] : all_filters()) {
    float previous = -std::numeric_limits<float>::infinity();
    for (int i = 0; i <= 4096; ++i) {
      const float u = i == 4096 ? kOneMinusEpsilon : static_cast<float>(i) / 4096.F;
      const FilterSample s = filter.sample({u, u});
      ASSERT_TRUE(std::isfinite(s.weight)) << name;
      ASSERT_GE(s.offset.x, previous) << name << " at u = " << u;
      ASSERT_GE(s.offset.x, -filter.radius().x) << name;
      ASSERT_LT(s.offset.x, filter.radius().x) << name;
      ASSERT_GE(s.offset.y, -filter.radius().y) << name;
      ASSERT_LT(s.offset.y, filter.radius().y) << name;
      previous = s.offset.x;
    }
  }
}

TEST(Filter, RefusesInvalidParameters) {
  EXPECT_THROW(Filter::box({0.F, 1.F}), SceneError);
  EXPECT_THROW(Filter::box({-1.F, 1.F}), SceneError);
  EXPECT_THROW(Filter::triangle({1.F, 1000.F}), SceneError);
  EXPECT_THROW(Filter::box({std::numeric_limits<float>::quiet_NaN(), 1.F}), SceneError);
  EXPECT_THROW(Filter::gaussian({2.F, 2.F}, 0.F), SceneError);
  EXPECT_THROW(Filter::gaussian({2.F, 2.F}, -1.F), SceneError);
  EXPECT_THROW(Filter::sinc({2.F, 2.F}, 0.F), SceneError);
}

}  // namespace
}  // namespace ajar
