#include "mcmc/primary/unit_grid.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/vector.h"

namespace ajar {
namespace {

TEST(UnitGrid, StaysBelowOneAndNotBelowZero) {
  for (const float u : {0.F, 0x1p-24F, 0.5F, kOneMinusEpsilon}) {
    for (const float d : {0.F, 1e-9F, 0x1p-24F, 0.3F, 1.F, 63.99F}) {
      for (const float distance : {d, -d}) {
        const float moved = add_on_unit_circle(u, distance);
        EXPECT_GE(moved, 0.F);
        EXPECT_LT(moved, 1.F);
        const double expected = double{u} + double{distance};
        const double difference = double{moved} - (expected - std::floor(expected));
        EXPECT_LE(std::abs(difference - std::round(difference)), 0x1p-25) << u << " + " << distance;
      }
    }
  }
  EXPECT_EQ(add_on_unit_circle(kOneMinusEpsilon, 0x1p-24F), 0.F);
  EXPECT_EQ(add_on_unit_circle(0.F, -0x1p-24F), kOneMinusEpsilon);
}

TEST(UnitGrid, EveryStepIsReversible) {
  Rng rng(3);
  for (int i = 0; i < 100000; ++i) {
    const float u = rng.next();
    const float distance = 4.F * rng.next() - 2.F;
    EXPECT_EQ(add_on_unit_circle(add_on_unit_circle(u, distance), -distance), u);
  }
}

}  // namespace
}  // namespace ajar
