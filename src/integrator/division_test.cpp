#include "integrator/division.h"

#include <gtest/gtest.h>

#include <limits>

namespace ajar {
namespace {

Contribution contribution(float value, Technique technique, float roulette_weight = 1.F) {
  return {.value = Spectrum(value),
          .technique = technique,
          .mis_weight = 1.0,
          .roulette_weight = roulette_weight};
}

/// Where the map has no say.
const Vec2 kAnywhere(0.5F, 0.5F);

TEST(Division, LeavesDirectLightToOrdinaryMonteCarlo) {
  const ImportanceMap importance;
  const Division division(1.0, importance);
  for (const Technique technique :
       {Technique{0, 2}, Technique{0, 3}, Technique{1, 2}, Technique{2, 1}}) {
    EXPECT_FALSE(Division::divides(technique));
    EXPECT_EQ(division.chain_fraction(contribution(1e6F, technique), kAnywhere), 0.F);
  }
  EXPECT_TRUE(Division::divides({2, 2}));
}

TEST(Division, DividesEvenlyAtTheThreshold) {
  const ImportanceMap importance;
  const Division division(3.0, importance);
  EXPECT_NEAR(division.chain_fraction(contribution(3.F, {2, 2}), kAnywhere), 0.5F, 1e-6);
  EXPECT_NEAR(division.chain_fraction(contribution(27.F, {2, 2}), kAnywhere), 0.9F, 1e-6);
  EXPECT_EQ(division.chain_fraction(contribution(0.F, {2, 2}), kAnywhere), 0.F);
}

TEST(Division, SharesAddUpToOneAndOrdinaryMonteCarloStaysBelowTheThreshold) {
  const ImportanceMap importance(Box2i(Vec2i(0, 0), Vec2i(1, 0)), {1.F, 3.F});
  const Division division(2.0, importance);
  for (const float value : {1e-20F, 1e-3F, 1.F, 50.F, 1e4F}) {
    for (const float x : {0.5F, 1.5F}) {
      const Contribution path = contribution(value, {0, 5});
      const Vec2 raster(x, 0.5F);
      const float chain = division.chain_fraction(path, raster);
      const float omc = division.omc_fraction(path, raster);
      EXPECT_NEAR(chain + omc, 1.F, 1e-6);
      EXPECT_LE(omc * division.strength(path, raster), 2.F * 1.001F);
    }
  }
}

TEST(Division, IgnoresRouletteWeights) {
  const ImportanceMap importance;
  const Division division(5.0, importance);
  const float sure = division.chain_fraction(contribution(2.F, {3, 2}), kAnywhere);
  EXPECT_FLOAT_EQ(division.chain_fraction(contribution(16.F, {3, 2}, 8.F), kAnywhere), sure)
      << "a survivor of Russian roulette is the same path";
}

TEST(Division, PassesOnNanAndInfinity) {
  const ImportanceMap importance;
  const Division division(5.0, importance);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(division.chain_fraction(contribution(nan, {3, 2}), kAnywhere), 0.F);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(division.chain_fraction(contribution(infinity, {3, 2}), kAnywhere), 1.F);
}

TEST(Division, SharesAddUpToOneWhateverTheMapAndWhereverThePath) {
  const Box2i crop(Vec2i(2, 3), Vec2i(4, 4));
  std::vector<PixelDivision> pixels = {{0.F, 1.F, 1.F},  {0.F, 0.F, 0.F},  {5.F, 0.3F, 0.3F},
                                       {0.F, 0.1F, 0.F}, {2.F, 0.7F, 1.F}, {9.F, 1.F, 1.F}};
  const ImportanceMap importance;
  const Division division(crop, pixels, importance);
  for (int row = 7; row < 24; ++row) {
    for (int column = 3; column < 28; ++column) {
      for (const float value : {1e-6F, 0.5F, 3.F, 1e5F}) {
        const Contribution path = contribution(value, {2, 3});
        const Vec2 raster(0.25F * static_cast<float>(column), 0.25F * static_cast<float>(row));
        EXPECT_NEAR(division.chain_fraction(path, raster) * division.deposit_scale(raster) +
                        division.omc_fraction(path, raster),
                    1.F, 1e-6F);
      }
    }
  }
  EXPECT_EQ(division.at({2.5F, 4.5F}).target_scale, 0.1F);
  EXPECT_EQ(division.at({100.F, -100.F}).target_scale, 0.3F)
      << "beyond the border: the nearest pixel";
}

TEST(Divisions, AreForAllReplicatesOrForEitherHalf) {
  const ImportanceMap importance;
  const Divisions one(Division(1.0, importance));
  EXPECT_EQ(&one.of(0), &one.of(3));
  const Divisions two(Division(1.0, importance), Division(2.0, importance));
  EXPECT_EQ(two.of(2).at({0.F, 0.F}).threshold, 1.F);
  EXPECT_EQ(two.of(3).at({0.F, 0.F}).threshold, 2.F);
}

}  // namespace
}  // namespace ajar
