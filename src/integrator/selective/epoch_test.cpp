#include "integrator/selective/epoch.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

TEST(Epoch, EachSampleWeighsOneWithoutChains) {
  const Epoch epoch;
  EXPECT_EQ(epoch.sample_weight(), 1.0);
  EXPECT_EQ(epoch.weight_until(0), 0.0);
  EXPECT_EQ(epoch.weight_until(24), 24.0);
}

TEST(Epoch, SamplesOfEarlierEpochsKeepTheirWeight) {
  Epoch epoch;
  epoch.go_on(4, 0.5);
  EXPECT_EQ(epoch.begin(), 0U);
  EXPECT_EQ(epoch.end(), 4U);
  EXPECT_EQ(epoch.weight_until(4), 2.0);
  epoch.go_on(16, 3.0);
  EXPECT_EQ(epoch.begin(), 4U);
  EXPECT_EQ(epoch.weight_until(4), 2.0);
  EXPECT_EQ(epoch.weight_until(6), 2.0 + 2 * 3.0);
  epoch.go_on(32, 1.0);
  EXPECT_EQ(epoch.weight_until(17), 2.0 + 12 * 3.0 + 1.0);
}

}  // namespace
}  // namespace ajar
