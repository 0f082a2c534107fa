#include "image/tone_curve.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"

namespace ajar {
namespace {

TEST(Srgb, MatchesTheStandard) {
  EXPECT_EQ(srgb_from_linear(0.F), 0.F);
  EXPECT_NEAR(srgb_from_linear(1.F), 1.F, 1e-6);
  EXPECT_NEAR(srgb_from_linear(0.002F), 0.02584F, 1e-6);
  EXPECT_NEAR(srgb_from_linear(0.214041F), 0.5F, 1e-6);
  for (int i = 0; i <= 1000; ++i) {
    const float x = static_cast<float>(i) / 1000.F;
    EXPECT_NEAR(linear_from_srgb(srgb_from_linear(x)), x, 2e-6);
  }
}

TEST(ToneMap, ExposureIsInStops) {
  EXPECT_FLOAT_EQ(tone_map(0.1F, ToneMap::Srgb, 2.F), srgb_from_linear(0.4F));
  EXPECT_FLOAT_EQ(tone_map(0.4F, ToneMap::Srgb, -1.F), srgb_from_linear(0.2F));
}

TEST(ToneMap, FilmicCurveRisesFromBlackToWhite) {
  EXPECT_EQ(filmic_curve(0.F), 0.F);
  // (0.6·(2.51·0.6 + 0.03)) / (0.6·(2.43·0.6 + 0.59) + 0.14) at 1.
  EXPECT_NEAR(filmic_curve(1.F), 0.9216 / 1.3688, 1e-4);
  float previous = -1.F;
  for (int i = 0; i < 1000; ++i) {
    const float x = 0.01F * static_cast<float>(i);
    EXPECT_GE(filmic_curve(x), previous);
    previous = filmic_curve(x);
  }
  EXPECT_EQ(filmic_curve(1e30F), 1.F);
}

TEST(ToneMap, StaysInTheDisplayRange) {
  const float inf = std::numeric_limits<float>::infinity();
  for (const ToneMap curve : {ToneMap::Srgb, ToneMap::Filmic}) {
    for (const float x : {std::nanf(""), -inf, -1.F, 0.F, 1e-30F, 1.F, 1e30F, 3e38F, inf}) {
      for (const float exposure : {-200.F, 0.F, 5.F, 200.F}) {
        const float y = tone_map(x, curve, exposure);
        EXPECT_TRUE(y >= 0.F && y <= 1.F) << x << " at " << exposure << " gives " << y;
      }
    }
    EXPECT_EQ(tone_map(std::nanf(""), curve, 0.F), 0.F);
    EXPECT_NEAR(tone_map(inf, curve, 0.F), 1.F, 1e-6);
  }
}

TEST(ToneMap, IsFoundByName) {
  EXPECT_EQ(tone_map_by_name("srgb"), ToneMap::Srgb);
  EXPECT_EQ(tone_map_by_name("filmic"), ToneMap::Filmic);
  EXPECT_THROW(tone_map_by_name("film"), UsageError);
}

TEST(ToLdr, ClampsAndEncodes) {
  const std::vector<float> ldr = to_ldr(std::vector<float>{-1.F, 0.214041F, 7.F});
  EXPECT_EQ(ldr[0], 0.F);
  EXPECT_NEAR(ldr[1], 0.5F, 1e-6);
  EXPECT_NEAR(ldr[2], 1.F, 1e-6);
}

}  // namespace
}  // namespace ajar
