#include "post/denoise/builtin_denoiser.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

namespace ajar {
namespace {

constexpr Vec2i kRampSize{70, 50};
constexpr std::size_t kRampPixels = std::size_t{70} * 50;

/// Light of which only a filter that looks at several scales makes an even slope.
std::vector<float> ramp() {
  std::vector<float> values;
  for (std::size_t i = 0; i < kRampPixels; ++i) {
    const float value = 1.F + static_cast<float>(i % 70) / 70.F;
    values.insert(values.end(), {value, 0.5F * value, value});
  }
  return values;
}

/// With noise of 50 %, another in each channel.
std::vector<float> noisy(std::vector<float> truth, unsigned seed) {
  std::mt19937 random(seed);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same test each time
  std::gamma_distribution<float> noise(4.F, 0.25F);
  for (float& value : truth) value *= noise(random);
  return truth;
}

std::vector<float> mean_of(const std::vector<float>& a, const std::vector<float>& b) {
  std::vector<float> mean(a.size());
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5F * (a[i] + b[i]);
  return mean;
}

double squared_error(const std::vector<float>& values, const std::vector<float>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    sum += std::pow(double{values[i]} / double{truth[i]} - 1.0, 2);
  }
  return sum / static_cast<double>(truth.size());
}

double light_of(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Two halves of a picture, and the filter's result.
struct Filtered {
  explicit Filtered(const std::vector<float>& truth, const Features& features = {},
                    const Denoiser::Progress& progress = {})
      : first(noisy(truth, 1)), second(noisy(truth, 2)), whole(mean_of(first, second)) {
    const BuiltinDenoiser denoiser;
    result = denoiser.filter({.size = kRampSize, .colour = whole, .halves = {first, second}},
                             denoiser.prepare(kRampSize, features), progress);
  }
  std::vector<float> first;
  std::vector<float> second;
  std::vector<float> whole;
  std::optional<std::vector<float>> result;
};

TEST(BuiltinDenoiser, RemovesNoiseAndKeepsLight) {
  const std::vector<float> truth = ramp();
  const Filtered filtered(truth);
  EXPECT_LT(squared_error(*filtered.result, truth), 0.02 * squared_error(filtered.whole, truth));
  EXPECT_NEAR(light_of(*filtered.result) / light_of(filtered.whole), 1.0, 0.005);
}

TEST(BuiltinDenoiser, WorksWithoutHalves) {
  const std::vector<float> truth = ramp();
  const std::vector<float> picture = noisy(truth, 1);
  const auto result = BuiltinDenoiser().filter({.size = kRampSize, .colour = picture}, {}, {});
  EXPECT_LT(squared_error(*result, truth), 0.05 * squared_error(picture, truth));
}

TEST(BuiltinDenoiser, LeavesAPictureWithoutNoiseAsItIs) {
  // An edge of shadow, of which features know nothing.
  std::vector<float> truth = ramp();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (i / 3 / 70 > 25) truth[i] *= 0.1F;
  }
  const auto result = BuiltinDenoiser().filter(
      {.size = kRampSize, .colour = truth, .halves = {truth, truth}}, {}, {});
  EXPECT_LT(squared_error(*result, truth), 1e-4);
}

TEST(BuiltinDenoiser, KeepsEdgesOfFeatures) {
  // Two walls, one of which receives less light than the noise of a pixel.
  std::vector<float> truth = ramp();
  Features features{std::vector<float>(3 * kRampPixels, 0.5F),
                    std::vector<float>(3 * kRampPixels, 0.F)};
  for (std::size_t i = 0; i < kRampPixels; ++i) {
    const bool faces_light = i % 70 < 35;
    features.normal[3 * i + (faces_light ? 0 : 1)] = 1.F;
    for (std::size_t v = 3 * i; v < 3 * i + 3; ++v) truth[v] *= faces_light ? 1.F : 0.7F;
  }
  const auto step = [&](const std::vector<float>& picture) {
    double before = 0.0;
    double after = 0.0;
    for (std::size_t y = 0; y < 50; ++y) {
      before += double{picture[3 * (70 * y + 34)]};
      after += double{picture[3 * (70 * y + 35)]};
    }
    return after / before;
  };
  EXPECT_NEAR(step(*Filtered(truth, features).result), step(truth), 0.03);
  EXPECT_GT(step(*Filtered(truth).result), step(truth) + 0.06);
}

TEST(BuiltinDenoiser, KeepsTheLightOfFirefliesButNotTheirPixels) {
  const std::vector<float> truth = ramp();
  std::vector<float> first = noisy(truth, 1);
  const std::vector<float> second = noisy(truth, 2);
  const std::size_t firefly = std::size_t{3} * (70 * 25 + 35);
  for (std::size_t v = firefly; v < firefly + 3; ++v) first[v] = 200.F;
  const std::vector<float> whole = mean_of(first, second);
  const auto result = BuiltinDenoiser().filter(
      {.size = kRampSize, .colour = whole, .halves = {first, second}}, {}, {});
  EXPECT_LT((*result)[firefly], 3.F);
  EXPECT_NEAR(light_of(*result) / light_of(whole), 1.0, 0.02);
}

TEST(BuiltinDenoiser, TakesPicturesOfAnySize) {
  for (const Vec2i& size : {Vec2i{1, 1}, {1, 40}, {33, 17}, {11, 300}}) {
    const std::vector<float> even(
        std::size_t{3} * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), 2.F);
    const auto result = BuiltinDenoiser().filter({.size = size, .colour = even}, {}, {});
    for (const float value : *result) ASSERT_NEAR(value, 2.F, 1e-4F);
  }
}

TEST(BuiltinDenoiser, ReplacesNanByBlack) {
  std::vector<float> picture = ramp();
  picture[0] = std::numeric_limits<float>::quiet_NaN();
  picture[100] = std::numeric_limits<float>::infinity();
  const auto result = BuiltinDenoiser().filter({.size = kRampSize, .colour = picture}, {}, {});
  for (const float value : *result) ASSERT_TRUE(std::isfinite(value));
  const std::vector<float> black(3 * kRampPixels, 0.F);
  EXPECT_EQ(light_of(*BuiltinDenoiser().filter({.size = kRampSize, .colour = black}, {}, {})), 0.0);
}

TEST(BuiltinDenoiser, MakesTheSamePixelsOnAnyThreads) {
  const std::vector<float> truth = ramp();
  const Filtered on_all(truth);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_TRUE(*on_all.result == *Filtered(truth).result);
}

TEST(BuiltinDenoiser, StopsOnRequest) {
  double most = 0.0;
  const std::vector<float> truth = ramp();
  EXPECT_TRUE(Filtered(truth, {}, [&](double done) {
                most = std::max(most, done);
                return true;
              }).result);
  EXPECT_GT(most, 0.9);
  EXPECT_FALSE(Filtered(truth, {}, [](double done) { return done < 0.2; }).result);
}

TEST(BuiltinDenoiser, RefusesOtherSizes) {
  const std::vector<float> truth = ramp();
  const BuiltinDenoiser denoiser;
  EXPECT_THROW(denoiser.filter({.size = {7, 7}, .colour = truth}, {}, {}), std::invalid_argument);
  EXPECT_THROW(denoiser.prepare({7, 7}, {truth, truth}), std::invalid_argument);
}

}  // namespace
}  // namespace ajar
