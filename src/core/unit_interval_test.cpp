#include "core/unit_interval.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace ajar {
namespace {

TEST(UnitInterval, NumbersLieWithin) {
  for (const UnitInterval& interval : {UnitInterval{0.0, 0.3}, UnitInterval{0.3, 0.7},
                                       UnitInterval{0.25, 1e-6}, UnitInterval{0.0, 1.0}}) {
    for (const float u : {0.F, 0.5F, kOneMinusEpsilon}) {
      const auto number = static_cast<double>(interval.at(u));
      EXPECT_GE(number, interval.begin);
      EXPECT_LT(number, interval.begin + interval.size);
      EXPECT_NEAR(number, interval.begin + static_cast<double>(u) * interval.size, 4e-7);
    }
  }
  EXPECT_EQ(UnitInterval().at(0.123F), 0.123F) << "all of it: the number itself";
}

TEST(UnitInterval, PartsNest) {
  const UnitInterval part = UnitInterval{0.2, 0.5}.part({0.5, 0.25});
  EXPECT_DOUBLE_EQ(part.begin, 0.45);
  EXPECT_DOUBLE_EQ(part.size, 0.125);
}

TEST(UnitInterval, ChoiceIsProportionalAndTheNumberIsUniformAgain) {
  Rng rng(1);
  int first = 0;
  double sum = 0.0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    float u = rng.next();
    first += came_first(0.5, 1.5, u) ? 1 : 0;
    ASSERT_TRUE(u >= 0.F && u < 1.F);
    sum += static_cast<double>(u);
  }
  // Five standard errors: 0.7 %.
  EXPECT_NEAR(first / double{kDraws}, 0.25, 0.007);
  EXPECT_NEAR(sum / kDraws, 0.5, 0.005);
}

}  // namespace
}  // namespace ajar
