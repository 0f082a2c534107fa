#include "integrator/metropolis/path_target.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/random.h"

namespace ajar {
namespace {

float unit(int i) { return to_unit_float(static_cast<std::uint32_t>(hash_numbers(3, i) >> 32U)); }

/// Frequency of each technique in so many tries.
std::vector<int> frequencies(const TechniqueChoice& choice, int tries) {
  std::vector<int> counts(choice.size(), 0);
  for (int i = 0; i < tries; ++i) ++counts[choice.choose(unit(i)).number];
  return counts;
}
/// Probabilities as `choose` reports them, by number; 0 for what is never chosen.
std::vector<double> probabilities(const TechniqueChoice& choice) {
  std::vector<double> result(choice.size(), 0.0);
  for (int i = 0; i < 10000; ++i) {
    const TechniqueChoice::Chosen chosen = choice.choose(unit(i));
    result[chosen.number] = static_cast<double>(chosen.probability);
  }
  return result;
}
double sum(const std::vector<double>& values) {
  double total = 0.0;
  for (const double value : values) total += value;
  return total;
}

TEST(TechniqueChoice, HoldsTheTechniquesOfOneDepth) {
  const TechniqueChoice all(TechniqueSet::bdpt(), 4);
  ASSERT_EQ(all.size(), 5U);  // (0,5) (1,4) (2,3) (3,2) (4,1)
  for (int s = 0; s < 5; ++s) {
    EXPECT_EQ(all[static_cast<std::size_t>(s)], (Technique{s, 5 - s}));
  }
  const TechniqueChoice few(TechniqueSet::ibpt(), 4);
  ASSERT_EQ(few.size(), 3U);
  EXPECT_EQ(few[2], (Technique{4, 1}));
  EXPECT_EQ(TechniqueChoice(TechniqueSet::bdpt(), 1).size(), 1U) << "what the lens sees directly";
  EXPECT_TRUE(TechniqueChoice(TechniqueSet::parse("(1,2)"), 3).empty());
}

TEST(TechniqueChoice, ChoosesEachTechniqueAsOftenAsItSays) {
  const TechniqueChoice choice(TechniqueSet::bdpt(), 5);
  const std::vector<double> expected = probabilities(choice);
  EXPECT_NEAR(sum(expected), 1.0, 1e-6);
  constexpr int kTries = 200000;
  const std::vector<int> counts = frequencies(choice, kTries);
  double chi_squared = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double mean = kTries * expected[i];
    chi_squared += (counts[i] - mean) * (counts[i] - mean) / mean;
  }
  // 5 degrees of freedom: above 37 with a chance of 6e-7. A probability wrong by 5 % of a fifth
  // of all tries adds 100.
  EXPECT_LT(chi_squared, 37.0);
}

TEST(TechniqueChoice, ChoosesSomethingForEveryNumber) {
  const TechniqueChoice choice(TechniqueSet::bdpt(), 9);
  const float largest = 1.F - std::numeric_limits<float>::epsilon() / 2.F;
  for (const float u : {0.F, 0.5F, largest}) {
    const TechniqueChoice::Chosen chosen = choice.choose(u);
    EXPECT_LT(chosen.number, choice.size());
    EXPECT_EQ(chosen.technique, choice[chosen.number]);
    EXPECT_GT(chosen.probability, 0.F);
  }
}

TEST(TechniqueChoice, IsMadeByTheNumberOfATechnique) {
  const TechniqueChoice choice(TechniqueSet::bdpt(), 7);
  for (std::size_t i = 0; i < choice.size(); ++i) {
    for (const float u : {0.F, 0.3F, 0x1.fffffep-1F}) {
      EXPECT_EQ(choice.choose(choice.number_of(choice[i], u)).technique, choice[i]);
    }
  }
}

TEST(Contribution, IsTheLuminanceTimesTheImportanceOfEachPlace) {
  const ImportanceMap map(Box2i(Vec2i(0, 0), Vec2i(1, 0)), {1.F, 3.F});
  const std::vector<Splat> splats = {{Vec2(0.5F, 0.5F), 0, Spectrum(2.F)},
                                     {Vec2(1.5F, 0.5F), 1, Spectrum(1.F)}};
  EXPECT_NEAR(contribution(splats, map), 2.0 * 0.5 + 1.0 * 1.5, 1e-5);
  EXPECT_EQ(contribution({}, map), 0.0);
}

TEST(Contribution, OfALaneBelowZeroIsBelowZero) {
  const std::vector<Splat> splats = {{Vec2(0.F, 0.F), 0, Spectrum(9.F, 9.F, -0.1F)}};
  EXPECT_LT(contribution(splats, ImportanceMap()), 0.0);
}

TEST(ChainView, FindsTheNumbersOfAPlaceAgain) {
  ChainView view;
  view.low = Vec2(3.F, -1.F);
  view.size = Vec2(40.F, 20.F);
  for (const Vec2& at : {Vec2(3.F, -1.F), Vec2(17.3F, 5.5F), Vec2(42.9F, 18.99F)}) {
    const Vec2 again = view.raster(view.place(at));
    EXPECT_NEAR(again.x, at.x, 1e-5);
    EXPECT_NEAR(again.y, at.y, 1e-5);
  }
  EXPECT_LT(view.place(Vec2(43.F, 19.F)).x, 1.F) << "the border belongs to the last number";
}

TEST(ChainView, CoversItsRectangleAndNothingElse) {
  ChainView view;
  view.low = Vec2(3.F, -1.F);
  view.size = Vec2(4.F, 2.F);
  EXPECT_EQ(view.area(), 8.0);
  EXPECT_EQ(view.raster(Vec2(0.5F, 0.25F)).x, 5.F);
  EXPECT_EQ(view.raster(Vec2(0.5F, 0.25F)).y, -0.5F);
  EXPECT_TRUE(view.contains(Vec2(3.F, -1.F)));
  EXPECT_TRUE(view.contains(Vec2(6.99F, 0.99F)));
  EXPECT_FALSE(view.contains(Vec2(7.F, 0.F)));
  EXPECT_FALSE(view.contains(Vec2(5.F, 1.F)));
  EXPECT_FALSE(view.contains(Vec2(2.99F, 0.F)));
}

}  // namespace
}  // namespace ajar
