#include "scene/medium/color_field.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "core/random.h"
#include "scene/medium/medium.h"

namespace ajar {
namespace {

using desc::DensityGrid;

constexpr float kNoEnd = std::numeric_limits<float>::infinity();

desc::Density placed(DensityGrid grid, const Mat4& to_world = Mat4()) {
  return {std::make_shared<const DensityGrid>(std::move(grid)), to_world};
}

/// Along x in the unit cube: red absorbs and green scatters in the first half, blue absorbs and all
/// scatter in the second.
desc::Density two_colors(DensityGrid::Border border) {
  DensityGrid grid{{2, 1, 1}, {}, DensityGrid::Points::Centers, border};
  grid.absorption = {{4, 0, 0}, {0, 0, 3}};
  grid.scattering = {{0, 2, 0}, {1, 0.5F, 2}};
  return placed(std::move(grid));
}

/// σ_t of its points, with those coefficients.
const Spectrum kSigmaA(0.5F, 1.F, 2.F);
const Spectrum kSigmaS(3.F, 1.F, 0.25F);
const double kFirst[3] = {2.0, 2.0, 0.0};
const double kSecond[3] = {3.0, 0.5, 6.5};

/// Extinction of a lane, clamped at the border: as the first point up to 1/4, as the second from
/// 3/4 on.
double extinction(int lane, double x) {
  const double t = std::clamp((x - 0.25) / 0.5, 0.0, 1.0);
  return kFirst[lane] + (kSecond[lane] - kFirst[lane]) * t;
}
/// Its integral from 0 to x.
double depth(int lane, double x) {
  const double in_middle = std::clamp(x - 0.25, 0.0, 0.5);
  return kFirst[lane] * x +
         (kSecond[lane] - kFirst[lane]) * (in_middle * in_middle + std::max(0.0, x - 0.75));
}

const Ray kAxis{{-1.F, 0.3F, 0.6F}, {1.F, 0.F, 0.F}};

TEST(ColorField, HasTheDepthsOfItsClosedForm) {
  const ColorField field(two_colors(DensityGrid::Border::Clamp), kSigmaA, kSigmaS);
  for (double x = 0.05; x < 1.0; x += 0.1) {
    const Crossing crossing = field.along(kAxis, static_cast<float>(1.0 + x), 0, kNoEnd);
    EXPECT_FALSE(crossing.reached);
    const Vec3 place(static_cast<float>(x), 0.3F, 0.6F);
    for (int lane = 0; lane < 3; ++lane) {
      EXPECT_NEAR(crossing.depth[lane], depth(lane, x), 1e-6) << x << ' ' << lane;
      EXPECT_NEAR(field.sigma_t(place)[lane], extinction(lane, x), 1e-6) << x << ' ' << lane;
    }
  }
  const Crossing whole = field.along(kAxis, kNoEnd, 0, kNoEnd);
  EXPECT_EQ(whole.distance, kNoEnd);
  for (int lane = 0; lane < 3; ++lane) EXPECT_NEAR(whole.depth[lane], depth(lane, 1.0), 1e-6);
  EXPECT_NEAR(field.sigma_s({0.5F, 0.F, 0.F})[1], 0.5 * (2.0 + 0.5), 1e-6);
  EXPECT_NEAR(field.sigma_s({0.5F, 0.F, 0.F})[2], 0.5 * 0.25 * 2.0, 1e-6);
  EXPECT_EQ(field.sigma_t({0.1F, 0.F, 0.F})[2], 1e-12F * 6.5F) << "paths are divided by it";
}

TEST(ColorField, InvertsTheDepthOfALane) {
  const ColorField field(two_colors(DensityGrid::Border::Clamp), kSigmaA, kSigmaS);
  for (int lane = 0; lane < 3; ++lane) {
    for (double x = 0.05; x < 1.0; x += 0.1) {
      const auto asked = static_cast<float>(depth(lane, x));
      const Crossing crossing = field.along(kAxis, kNoEnd, lane, asked);
      if (lane == 2 && x < 0.25) continue;  // there is nothing
      ASSERT_TRUE(crossing.reached) << lane << ' ' << x;
      EXPECT_NEAR(crossing.distance, 1.0 + x, 1e-5) << lane;
      EXPECT_EQ(crossing.depth[lane], asked);
      for (int other = 0; other < 3; ++other) {
        EXPECT_NEAR(crossing.depth[other], depth(other, x), 1e-4) << lane << ' ' << x;
      }
    }
    const auto beyond = static_cast<float>(depth(lane, 1.0) * 1.0001);
    EXPECT_FALSE(field.along(kAxis, kNoEnd, lane, beyond).reached);
  }
}

TEST(ColorField, SamplesDistancesByTheMeanOfTheLanes) {
  const Medium medium(
      "smoke", 0.F,
      std::make_unique<const ColorField>(two_colors(DensityGrid::Border::Clamp), kSigmaA, kSigmaS));
  // The last bin is for light that crosses the box.
  constexpr std::size_t kBins = 40;
  constexpr int kSamples = 100000;
  std::array<double, kBins + 1> found{};
  Rng rng(3);
  for (int i = 0; i < kSamples; ++i) {
    const int lane = std::min(static_cast<int>(rng.next() * 3.F), 2);
    const Crossing end = medium.along(kAxis, kNoEnd, lane, -std::log(1.F - rng.next()));
    const double x = static_cast<double>(end.distance) - 1.0;
    ++found[end.reached ? std::min(static_cast<std::size_t>(x * kBins), kBins - 1) : kBins];
  }
  const auto survival = [](double x) {
    return (std::exp(-depth(0, x)) + std::exp(-depth(1, x)) + std::exp(-depth(2, x))) / 3.0;
  };
  double statistic = 0.0;
  for (std::size_t bin = 0; bin <= kBins; ++bin) {
    const double from = survival(static_cast<double>(bin) / kBins);
    const double to = bin == kBins ? 0.0 : survival(static_cast<double>(bin + 1) / kBins);
    const double expected = (from - to) * kSamples;
    statistic += (found[bin] - expected) * (found[bin] - expected) / expected;
  }
  const boost::math::chi_squared_distribution<double> chi_squared(kBins);
  EXPECT_GT(boost::math::cdf(boost::math::complement(chi_squared, statistic)), 1e-4);
  // `Segment::distance_pdf` and survival add up to one.
  double sum = survival(1.0);
  constexpr int kPoints = 1000;
  for (int i = 0; i < kPoints; ++i) {
    const float x = (static_cast<float>(i) + 0.5F) / kPoints;
    const Spectrum tau = medium.along(kAxis, 1.F + x).depth;
    const Spectrum density = exp(tau * -1.F) * medium.sigma_t(kAxis.origin + Vec3(1.F + x, 0, 0));
    sum += static_cast<double>(density.average()) / kPoints;
  }
  EXPECT_NEAR(sum, 1.0, 1e-4);
}

TEST(ColorField, OfOneColorIsADensity) {
  Rng rng(5);
  DensityGrid scalar{{11, 10, 12}, {}, DensityGrid::Points::Centers, DensityGrid::Border::Zero};
  for (int i = 0; i < 11 * 10 * 12; ++i) scalar.values.push_back(i < 300 ? 0.F : rng.next());
  DensityGrid colored = scalar;
  colored.values.clear();
  for (const float value : scalar.values) {
    colored.absorption.emplace_back(value);
    colored.scattering.emplace_back(value);
  }
  const Spectrum sigma_a(0.5F, 1.F, 0.F);
  const Spectrum sigma_s(2.F, 0.F, 1.F);
  const Mat4 skewed = {2, 0.1, 0, 0, -0.2, 3, 0.3, 0, 0, 0.4, 1.5, 0, -1, -1.5, -0.75, 1};
  const Medium grey("grey", sigma_a, sigma_s, 0.F,
                    std::make_unique<const DensityField>(placed(scalar, skewed)));
  const Medium colors(
      "colours", 0.F,
      std::make_unique<const ColorField>(placed(colored, skewed), sigma_a, sigma_s));
  EXPECT_TRUE(colors.scatters());
  const auto expect_same = [](const Spectrum& a, const Spectrum& b) {
    for (int lane = 0; lane < 3; ++lane) {
      EXPECT_NEAR(a[lane], b[lane], 2e-6F * std::max(1.F, b[lane]));
    }
  };
  int ended = 0;
  for (int i = 0; i < 500; ++i) {
    const auto number = [&] { return 2.F * rng.next() - 1.F; };
    const Vec3 origin(3.F * number(), 3.F * number(), 3.F * number());
    const Vec3 target(number(), number(), number());
    const Ray ray{origin, (target - origin) / length(target - origin)};
    expect_same(colors.along(ray, 2.F).depth, grey.along(ray, 2.F).depth);
    expect_same(colors.sigma_t(target), grey.sigma_t(target));
    expect_same(colors.sigma_s(target), grey.sigma_s(target));
    const int lane = i % 3;
    const float most = rng.next();
    const Crossing expected = grey.along(ray, kNoEnd, lane, most);
    const Crossing found = colors.along(ray, kNoEnd, lane, most);
    ASSERT_EQ(found.reached, expected.reached);
    expect_same(found.depth, expected.depth);
    if (!found.reached) continue;
    EXPECT_NEAR(found.distance, expected.distance, 1e-5F);
    ++ended;
  }
  EXPECT_GT(ended, 100);
}

TEST(ColorField, WithoutOneOfItsGridsHasThatCoefficientUpToTheFaces) {
  DensityGrid grid{{2, 1, 1}, {}, DensityGrid::Points::Centers, DensityGrid::Border::Zero};
  grid.scattering = {{1, 0, 0}, {1, 2, 0}};
  const ColorField field(placed(std::move(grid)), Spectrum(0.5F), Spectrum(1.F));
  const Ray middle{{-1.F, 0.5F, 0.5F}, {1.F, 0.F, 0.F}};
  // Half a cell inside of each face the scattering falls to its half; absorption never does.
  const Spectrum whole = field.along(middle, kNoEnd, 0, kNoEnd).depth;
  EXPECT_NEAR(whole[2], 0.5, 1e-6);
  EXPECT_NEAR(whole[0], 0.5 + 0.5 + 2.0 * 0.25 * 0.75, 1e-6);
  EXPECT_NEAR(whole[1], 0.5 + 0.5 * 1.0 + 0.25 * 1.5, 1e-6);
  EXPECT_NEAR(field.sigma_t({0.F, 0.5F, 0.5F})[0], 0.5 + 0.5, 1e-6);
  EXPECT_TRUE(field.scatters());
  DensityGrid red{{1, 1, 1}, {}};
  red.absorption = {{1, 0, 0}};
  EXPECT_FALSE(ColorField(placed(red), Spectrum(1.F), Spectrum(0.F)).scatters());
  EXPECT_TRUE(ColorField(placed(red), Spectrum(1.F), Spectrum(1.F)).scatters());
}

}  // namespace
}  // namespace ajar
