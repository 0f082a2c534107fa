#include "post/denoise/oidn_denoiser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace ajar {
namespace {

constexpr Vec2i kSize{64, 48};
constexpr std::size_t kPixels = std::size_t{64} * 48;

/// A ramp of radiance with noise of 30 %, the same in all channels.
std::vector<float> noisy_ramp() {
  std::mt19937 random(1);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same test each time
  std::normal_distribution<float> noise(1.F, 0.3F);
  std::vector<float> values;
  for (std::size_t i = 0; i < kPixels; ++i) {
    const float value = (1.F + static_cast<float>(i % 64) / 64.F) * noise(random);
    values.insert(values.end(), {value, value, value});
  }
  return values;
}

double squared_error(const std::vector<float>& values) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kPixels; ++i) {
    const double truth = 1.0 + static_cast<double>(i % 64) / 64.0;
    sum += std::pow(double{values[3 * i]} / truth - 1.0, 2);
  }
  return sum / static_cast<double>(kPixels);
}

class OidnDenoiserTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string trouble;
    const auto library = find_oidn(&trouble);
    if (!library) GTEST_SKIP() << "Open Image Denoise 2 is not on this machine " << trouble;
    denoiser_ = std::make_unique<OidnDenoiser>(library);
  }
  std::unique_ptr<OidnDenoiser> denoiser_;
};

TEST_F(OidnDenoiserTest, NamesItsVersion) { EXPECT_TRUE(denoiser_->name().starts_with("oidn 2.")); }

TEST_F(OidnDenoiserTest, RemovesNoiseAndKeepsLight) {
  const std::vector<float> noisy = noisy_ramp();
  const auto clean = denoiser_->filter({kSize, noisy}, {}, {});
  ASSERT_TRUE(clean);
  EXPECT_LT(squared_error(*clean), 0.05 * squared_error(noisy));
  const double before = std::accumulate(noisy.begin(), noisy.end(), 0.0);
  EXPECT_NEAR(std::accumulate(clean->begin(), clean->end(), 0.0) / before, 1.0, 0.01);
}

TEST_F(OidnDenoiserTest, KeepsEdgesOfFeatures) {
  // Stripes of albedo under even light.
  Features features{std::vector<float>(3 * kPixels), std::vector<float>(3 * kPixels, 0.577F)};
  std::vector<float> noisy = noisy_ramp();
  for (std::size_t i = 0; i < 3 * kPixels; ++i) {
    const bool stripe = (i / 3 / 64) % 4 < 2;
    features.albedo[i] = stripe ? 0.8F : 0.2F;
    noisy[i] *= features.albedo[i];
  }
  const auto contrast = [&](const Features& known) {
    const auto clean = denoiser_->filter({kSize, noisy}, known, {});
    double bright = 0.0;
    double dark = 0.0;
    for (std::size_t i = 0; i < 3 * kPixels; ++i) {
      (features.albedo[i] > 0.5F ? bright : dark) += double{(*clean)[i]};
    }
    return bright / dark;
  };
  const double with = contrast(denoiser_->prepare(kSize, features));
  EXPECT_NEAR(with, 4.0, 0.2);
}

TEST_F(OidnDenoiserTest, ReplacesNanByBlack) {
  std::vector<float> noisy = noisy_ramp();
  noisy[100] = std::numeric_limits<float>::quiet_NaN();
  noisy[1000] = std::numeric_limits<float>::infinity();
  const auto clean = denoiser_->filter({kSize, noisy}, {}, {});
  ASSERT_TRUE(clean);
  EXPECT_TRUE(std::all_of(clean->begin(), clean->end(), [](float v) { return std::isfinite(v); }));
}

TEST_F(OidnDenoiserTest, KeepsLightHoweverBrightOrDim) {
  std::vector<float> at_the_end(3 * kPixels, 3e38F);
  const auto clean_end = denoiser_->filter({kSize, at_the_end}, {}, {});
  ASSERT_TRUE(clean_end);
  for (const float value : *clean_end) {
    ASSERT_TRUE(std::isfinite(value));
    ASSERT_NEAR(value, 3e38F, 0.15e38F);
  }
  for (const float scale : {1e37F, 1e30F, 1e15F, 1e-7F, 1e-10F, 1e-20F, 1e-30F}) {
    std::vector<float> noisy = noisy_ramp();
    for (float& value : noisy) value *= scale;
    const auto clean = denoiser_->filter({kSize, noisy}, {}, {});
    ASSERT_TRUE(clean);
    const double before = std::accumulate(noisy.begin(), noisy.end(), 0.0);
    EXPECT_NEAR(std::accumulate(clean->begin(), clean->end(), 0.0) / before, 1.0, 0.01) << scale;
    EXPECT_LT(*std::max_element(clean->begin(), clean->end()), 4.F * scale);
  }
}

TEST_F(OidnDenoiserTest, StopsOnRequest) {
  const std::vector<float> noisy = noisy_ramp();
  EXPECT_FALSE(denoiser_->filter({kSize, noisy}, {}, [](double) { return false; }));
}

TEST_F(OidnDenoiserTest, RefusesSizesThatDoNotFit) {
  const std::vector<float> noisy(12, 1.F);
  EXPECT_THROW((void)denoiser_->filter({kSize, noisy}, {}, {}), std::invalid_argument);
}

TEST_F(OidnDenoiserTest, IsTheSameToTheBit) {
  const std::vector<float> noisy = noisy_ramp();
  EXPECT_EQ(denoiser_->filter({kSize, noisy}, {}, {}), denoiser_->filter({kSize, noisy}, {}, {}));
}

}  // namespace
}  // namespace ajar
