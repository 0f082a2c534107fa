#include "integrator/selective/epoch.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

TEST(Epoch, WithoutRecruitsEachSampleWeighsOne) {
  const Epoch stretch;
  EXPECT_EQ(stretch.sample_weight(), 1.0);
  EXPECT_EQ(stretch.weight_until(0), 0.0);
  EXPECT_EQ(stretch.weight_until(24), 24.0);
}

TEST(Epoch, SamplesOfEarlierStretchesKeepTheirWeight) {
  Epoch stretch;
  stretch.go_on(4, 0.5);
  EXPECT_EQ(stretch.begin(), 0U);
  EXPECT_EQ(stretch.end(), 4U);
  EXPECT_EQ(stretch.weight_until(4), 2.0);
  stretch.go_on(16, 3.0);
  EXPECT_EQ(stretch.begin(), 4U);
  EXPECT_EQ(stretch.weight_until(4), 2.0);
  EXPECT_EQ(stretch.weight_until(6), 2.0 + 2 * 3.0);
  stretch.go_on(32, 1.0);
  EXPECT_EQ(stretch.weight_until(17), 2.0 + 12 * 3.0 + 1.0);
}

}  // namespace
}  // namespace ajar
