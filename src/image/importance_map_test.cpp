#include "image/importance_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace ajar {
namespace {

/// Pixels (x, y) to (x + width − 1, y + height − 1).
Box2i pixels(int x, int y, int width, int height) {
  return {Vec2i(x, y), Vec2i(x + width - 1, y + height - 1)};
}
float at(const ImportanceMap& map, int x, int y) {
  return map(Vec2(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F));
}

TEST(ImportanceMap, IsOneEverywhereByDefault) {
  const ImportanceMap map;
  EXPECT_EQ(map(Vec2(-3.F, 1000.F)), 1.F);
}

TEST(ImportanceMap, HasAMeanOfOneAndKeepsRatios) {
  const ImportanceMap map(pixels(0, 0, 3, 1), {2.F, 4.F, 12.F});
  EXPECT_FLOAT_EQ(at(map, 0, 0), 1.F / 3.F);
  EXPECT_FLOAT_EQ(at(map, 1, 0), 2.F / 3.F);
  EXPECT_FLOAT_EQ(at(map, 2, 0), 2.F);
}

TEST(ImportanceMap, RaisesSmallWeightsToItsFloor) {
  const ImportanceMap map(pixels(0, 0, 4, 1), {0.F, 1e-6F, -3.F, 4.F});
  for (int x = 0; x < 3; ++x) EXPECT_EQ(at(map, x, 0), ImageHeuristics::kImportanceFloor) << x;
  const ImportanceMap own_floor(pixels(0, 0, 2, 1), {0.F, 4.F}, 0.25F);
  EXPECT_EQ(at(own_floor, 0, 0), 0.25F);
}

TEST(ImportanceMap, ReplacesNanByTheFloor) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const ImportanceMap map(pixels(0, 0, 4, 1), {nan, infinity, -infinity, 4.F});
  for (int x = 0; x < 3; ++x) EXPECT_EQ(at(map, x, 0), ImageHeuristics::kImportanceFloor) << x;
  EXPECT_FLOAT_EQ(at(map, 3, 0), 4.F);
}

TEST(ImportanceMap, RefusesWeightsThatCannotBeAMap) {
  EXPECT_THROW(ImportanceMap(pixels(0, 0, 2, 2), {1.F, 1.F, 1.F}), std::invalid_argument);
  EXPECT_THROW(ImportanceMap(pixels(0, 0, 2, 1), {0.F, -1.F}), std::invalid_argument);
  EXPECT_THROW(ImportanceMap(pixels(0, 0, 1, 1), {std::nanf("")}), std::invalid_argument);
}

TEST(ImportanceMap, FindsThePixelOfARasterPosition) {
  const ImportanceMap map(pixels(10, 20, 2, 2), {1.F, 2.F, 3.F, 4.F});
  const float unit = 1.F / 2.5F;
  EXPECT_FLOAT_EQ(map(Vec2(10.F, 20.F)), 1.F * unit);
  EXPECT_FLOAT_EQ(map(Vec2(10.999F, 20.999F)), 1.F * unit);
  EXPECT_FLOAT_EQ(map(Vec2(11.F, 20.F)), 2.F * unit);
  EXPECT_FLOAT_EQ(map(Vec2(10.F, 21.F)), 3.F * unit);
}

TEST(ImportanceMap, ExtendsBeyondItsBorder) {
  const ImportanceMap map(pixels(10, 20, 2, 2), {1.F, 2.F, 3.F, 4.F});
  const float unit = 1.F / 2.5F;
  EXPECT_FLOAT_EQ(map(Vec2(8.F, 18.F)), 1.F * unit);
  EXPECT_FLOAT_EQ(map(Vec2(-100.F, 20.5F)), 1.F * unit);
  EXPECT_FLOAT_EQ(map(Vec2(12.F, 19.9F)), 2.F * unit);
  EXPECT_FLOAT_EQ(map(Vec2(9.F, 22.F)), 3.F * unit);
  EXPECT_FLOAT_EQ(map(Vec2(1e6F, 1e6F)), 4.F * unit);
}

TEST(RelativeImportance, IsTheInverseOfTheLuminanceFarFromEdges) {
  // Left half 1, right half 10.
  constexpr int kWidth = 64;
  constexpr int kHeight = 16;
  std::vector<float> luminances;
  luminances.reserve(kWidth * kHeight);
  for (int i = 0; i < kWidth * kHeight; ++i) {
    luminances.push_back(i % kWidth < kWidth / 2 ? 1.F : 10.F);
  }
  const ImportanceMap map = ImportanceMap::relative(pixels(0, 0, kWidth, kHeight), luminances);
  // δ is a twentieth of the mean, 5.5.
  EXPECT_NEAR(at(map, 4, 8) / at(map, 60, 8), (10.0 + 0.275) / (1.0 + 0.275), 1e-3);
  double sum = 0.0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) sum += static_cast<double>(at(map, x, y));
    for (int x = 1; x < kWidth; ++x) EXPECT_LE(at(map, x, y), at(map, x - 1, y) * 1.00001F);
  }
  EXPECT_NEAR(sum / (kWidth * kHeight), 1.0, 1e-4);
}

TEST(RelativeImportance, IsEvenForAnEvenPictureUpToTheBorder) {
  const ImportanceMap map =
      ImportanceMap::relative(pixels(3, 5, 9, 7), std::vector<float>(63, 0.2F));
  for (int y = 5; y < 12; ++y) {
    for (int x = 3; x < 12; ++x) EXPECT_NEAR(at(map, x, y), 1.F, 1e-5F);
  }
}

TEST(RelativeImportance, IsRobustToFirefliesAndNan) {
  std::vector<float> luminances(32 * 32, 1.F);
  luminances[500] = 1e30F;
  luminances[100] = std::nanf("");
  luminances[101] = -5.F;
  luminances[102] = std::numeric_limits<float>::infinity();
  const ImportanceMap map = ImportanceMap::relative(pixels(0, 0, 32, 32), luminances);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      EXPECT_GE(at(map, x, y), ImageHeuristics::kImportanceFloor);
      EXPECT_LE(at(map, x, y), 32.F * 32.F);
    }
  }
}

TEST(RelativeImportance, IsTheSameHoweverDimOrBrightThePictureIs) {
  const std::vector<float> luminances = {1.F, 2.F, 0.5F, 3.F, 0.F, 7.F, 1.F, 4.F};
  const ImportanceMap map = ImportanceMap::relative(pixels(0, 0, 8, 1), luminances);
  // The inverses of the dimmest are no floats, and neither are twenty times the brightest.
  for (const int exponent : {-140, -125, -60, 60, 125}) {
    std::vector<float> scaled = luminances;
    for (float& value : scaled) value = std::ldexp(value, exponent);
    const ImportanceMap same = ImportanceMap::relative(pixels(0, 0, 8, 1), scaled);
    for (int x = 0; x < 8; ++x) EXPECT_EQ(at(same, x, 0), at(map, x, 0)) << exponent << ", " << x;
  }
}

TEST(RelativeImportance, OfABlackPictureIsUniform) {
  const ImportanceMap map = ImportanceMap::relative(pixels(0, 0, 2, 2), std::vector<float>(4, 0.F));
  EXPECT_EQ(at(map, 0, 0), 1.F);
  EXPECT_EQ(at(map, 1, 1), 1.F);
}

}  // namespace
}  // namespace ajar
