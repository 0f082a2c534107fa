#include "image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace ajar {
namespace {

const std::vector<float> kImage = {1.F, 2.F, 0.F, 4.F};
const std::vector<float> kReference = {1.F, 1.F, 0.5F, 2.F};

TEST(Metrics, MatchValuesByHand) {
  // Differences 0, 1, −0.5, 2.
  EXPECT_DOUBLE_EQ(mse(kImage, kReference), 5.25 / 4);
  EXPECT_DOUBLE_EQ(rmse(kImage, kReference), std::sqrt(5.25 / 4));
  EXPECT_DOUBLE_EQ(mae(kImage, kReference), 3.5 / 4);
  EXPECT_NEAR(smape(kImage, kReference), (1.0 / 3.01 + 0.5 / 0.51 + 2.0 / 6.01) / 4, 1e-12);
  EXPECT_DOUBLE_EQ(psnr(kImage, kReference), -10.0 * std::log10(5.25 / 4));
  EXPECT_DOUBLE_EQ(psnr(kImage, kReference, 10.0), 20.0 - 10.0 * std::log10(5.25 / 4));
  EXPECT_NEAR(relative_mse(kImage, kReference), (1.0 / 1.01 + 0.25 / 0.26 + 4.0 / 4.01) / 4, 1e-12);
}

TEST(Metrics, EqualImagesHaveNoError) {
  EXPECT_EQ(mse(kImage, kImage), 0.0);
  EXPECT_EQ(relative_mse(kImage, kImage), 0.0);
  EXPECT_EQ(psnr(kImage, kImage), std::numeric_limits<double>::infinity());
}

TEST(Metrics, TrimmingDropsTheWorstPixels) {
  // 2000 pixels: 0.1 % are two. The error of a pixel is 0.01/1.01 but for three outliers, one of
  // which is spread over its channels so that no single value of it is among the largest.
  std::vector<float> image(3 * 2000, 1.1F);
  const std::vector<float> reference(image.size(), 1.F);
  image[3 * 3 + 1] = std::nanf("");
  for (const std::size_t channel : {0U, 1U, 2U}) image[3 * 700 + channel] = 1.8F;
  image[3 * 1999] = 2.F;
  const double squared = (double{1.1F} - 1.0) * (double{1.1F} - 1.0);
  EXPECT_NEAR(relative_mse_trimmed(image, reference),
              (1997 * squared + (1.0 + 2 * squared) / 3) / 1.01 / 1998, 1e-12);
}

TEST(Metrics, TrimmingWithOneChannelDropsValues) {
  std::vector<float> image(2000, 1.1F);
  const std::vector<float> reference(image.size(), 1.F);
  image[3] = 1e6F;
  image[700] = std::nanf("");
  image[1999] = 2.F;
  const double squared = (double{1.1F} - 1.0) * (double{1.1F} - 1.0);
  EXPECT_NEAR(relative_mse_trimmed(image, reference, 1), (1997 * squared + 1.0) / 1.01 / 1998,
              1e-12);
}

TEST(Metrics, QuantileIsThatOfThePixels) {
  std::vector<float> image(3 * 2001, 1.F);
  const std::vector<float> reference(image.size(), 1.F);
  // Sorted error number 1998 of 2001, counted from 0: two are above it.
  image[3 * 17] = 4.F;
  image[3 * 18] = 4.F;
  image[3 * 900] = 2.F;
  EXPECT_NEAR(relative_mse_quantile(image, reference), 1.0 / 1.01 / 3, 1e-9);
  EXPECT_EQ(relative_mse_quantile(image, reference, 0.5), 0.0);
}

TEST(Metrics, ErrorByScaleIgnoresBlurredDetail) {
  constexpr Vec2i kSize{64, 64};
  const std::vector<float> reference(std::size_t{3} * 64 * 64, 1.F);
  std::vector<float> chequered = reference;
  std::vector<float> stained = reference;
  for (int i = 0; i < 3 * 64 * 64; ++i) {
    const int x = i / 3 % 64;
    const int y = i / 3 / 64;
    chequered[static_cast<std::size_t>(i)] += (x + y) % 2 == 0 ? 0.1F : -0.1F;
    stained[static_cast<std::size_t>(i)] += (x / 32 + y / 32) % 2 == 0 ? 0.1F : -0.1F;
  }
  EXPECT_NEAR(relative_mse(chequered, reference), relative_mse(stained, reference), 1e-6);
  EXPECT_LT(relative_mse_at_scale(chequered, reference, kSize, 2.0),
            1e-3 * relative_mse(chequered, reference));
  EXPECT_GT(relative_mse_at_scale(stained, reference, kSize, 2.0),
            0.7 * relative_mse(stained, reference));
}

TEST(Metrics, TrimmingLeavesFewPixelsAsTheyAre) {
  EXPECT_NEAR(relative_mse_trimmed(kImage, kReference, 2), relative_mse(kImage, kReference), 1e-12);
}

TEST(Metrics, PropagateNan) {
  EXPECT_TRUE(
      std::isnan(mse(std::vector<float>{std::nanf(""), 1.F}, std::vector<float>{1.F, 1.F})));
}

TEST(Metrics, RefuseDifferentSizes) {
  EXPECT_THROW(mse(kImage, std::vector<float>{1.F}), std::invalid_argument);
  EXPECT_THROW(relative_mse_trimmed({}, {}), std::invalid_argument);
  EXPECT_THROW(relative_mse_trimmed(kImage, kReference, 3), std::invalid_argument)
      << "four values are no pixels of three";
}

}  // namespace
}  // namespace ajar
