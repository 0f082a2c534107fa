#include "integrator/montecarlo/technique_tally.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

TEST(TechniqueTally, VarianceIsThatOfTheSamplesOfEachPixel) {
  TechniqueTally tally;
  // Technique (0, 3): 1, 3, 1, 3 → variance 4/3, four samples. (1, 2): always 2 → no variance.
  for (int i = 0; i < 4; ++i) {
    tally.add_camera_contribution({0, 3}, i % 2 == 0 ? 0.5F : 3.F);
    if (i % 2 == 0) tally.add_camera_contribution({0, 3}, 0.5F);
    tally.add_camera_contribution({1, 2}, 2.F);
    tally.end_sample();
  }
  tally.end_pixel(4.0);
  // Light tracing: two splats of 1 → 2 in all.
  tally.add_splat({2, 1}, 1.F);
  tally.add_splat({2, 1}, 1.F);
  const auto shares = tally.shares().list();
  ASSERT_EQ(shares.size(), 3U);
  const double variance = 4.0 * 4.0 / 3.0 + 2.0;
  EXPECT_EQ(shares[0].technique, (Technique{0, 3}));
  EXPECT_NEAR(shares[0].variance, 16.0 / 3.0 / variance, 1e-12);
  EXPECT_NEAR(shares[0].light, 8.0 / 18.0, 1e-12);
  EXPECT_NEAR(shares[1].variance, 0.0, 1e-12);
  EXPECT_NEAR(shares[2].variance, 2.0 / variance, 1e-12);
  EXPECT_NEAR(shares[2].light, 2.0 / 18.0, 1e-12);
}

TEST(TechniqueTally, PixelsDoNotMix) {
  TechniqueTally tally;
  for (int pixel = 0; pixel < 2; ++pixel) {
    for (int i = 0; i < 3; ++i) {
      tally.add_camera_contribution({1, 3}, static_cast<float>(10 * pixel + 1));
      tally.end_sample();
    }
    tally.end_pixel(3.0);
  }
  EXPECT_EQ(tally.shares().list().at(0).variance, 0.0);
}

TEST(TechniqueTally, DeepTechniquesAreKeptTogether) {
  TechniqueTally tally;
  tally.add_splat({40, 1}, 1.F);
  tally.add_splat({3, 90}, 1.F);
  const auto shares = tally.shares().list();
  ASSERT_EQ(shares.size(), 1U);
  EXPECT_EQ(shares[0].technique.s, TechniqueShares::kMaxVertices + 1);
  EXPECT_EQ(shares[0].light, 1.0);
}

}  // namespace
}  // namespace ajar
