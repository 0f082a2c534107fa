#include "core/perlin_noise.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace ajar {
namespace {

Vec3 random_point(Rng& rng, float size) {
  return {(rng.next() - 0.5F) * size, (rng.next() - 0.5F) * size, (rng.next() - 0.5F) * size};
}

TEST(Noise, IsZeroAtIntegerPoints) {
  for (int i = -3; i < 4; ++i) {
    EXPECT_EQ(noise(Vec3(static_cast<float>(i), static_cast<float>(2 * i), 5.F)), 0.F);
  }
}

TEST(Noise, StaysInRangeAndAveragesToZero) {
  Rng rng(1);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kSamples = 200000;
  for (int i = 0; i < kSamples; ++i) {
    const float v = noise(random_point(rng, 200.F));
    ASSERT_LE(std::abs(v), 1.05F);
    sum += v;
    squares += v * v;
  }
  EXPECT_NEAR(sum / kSamples, 0.0, 0.005);
  EXPECT_GT(squares / kSamples, 0.03);
}

TEST(Noise, IsContinuousAcrossCells) {
  Rng rng(2);
  for (int i = 0; i < 2000; ++i) {
    Vec3 p = random_point(rng, 20.F);
    p.x = std::floor(p.x);
    const Vec3 step(1e-4F, 0.F, 0.F);
    EXPECT_NEAR(noise(p + step), noise(p - step), 1e-3F);
  }
}

TEST(Noise, AgreesWithAHandComputedPoint) {
  // Middle of cell 0: all corners weigh 1/8, and gradients are dot products with (±½, ±½, ±½).
  const float v = noise({0.5F, 0.5F, 0.5F});
  EXPECT_NEAR(v * 8.F, std::round(v * 8.F), 1e-5F);
  // Near a corner only its gradient counts: the hash of cell (0,0,0) is p[p[p[0]]] = p[p[151]] =
  // p[17] = 36, whose last four bits, 4, choose the direction (1, 0, 1).
  const float e = 1e-3F;
  EXPECT_NEAR(noise({e, 0.F, 0.F}) / e, 1.F, 0.02F);
  EXPECT_NEAR(noise({0.F, e, 0.F}) / e, 0.F, 0.02F);
  EXPECT_NEAR(noise({0.F, 0.F, e}) / e, 1.F, 0.02F);
}

TEST(Noise, HugeAndInvalidPointsAreHarmless) {
  EXPECT_TRUE(std::isfinite(noise({1e30F, -1e20F, 3.F})));
  EXPECT_TRUE(std::isfinite(noise({NAN, 0.F, INFINITY})));
}

TEST(Fbm, OneOctaveIsNoise) {
  const Vec3 p(0.3F, 1.7F, -2.2F);
  EXPECT_FLOAT_EQ(fbm(p, 0.5F, 1), noise(p));
  EXPECT_FLOAT_EQ(fbm(p, 0.5F, 2), noise(p) + 0.5F * noise(p * 1.99F));
}

TEST(Turbulence, IsPositive) {
  Rng rng(4);
  for (int i = 0; i < 1000; ++i) EXPECT_GE(turbulence(random_point(rng, 50.F), 0.5F, 6), 0.F);
}

}  // namespace
}  // namespace ajar
