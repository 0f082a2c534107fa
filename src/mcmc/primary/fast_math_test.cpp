#include "mcmc/primary/fast_math.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/vector.h"

namespace ajar {
namespace {

constexpr int kNumbers = 200000;

TEST(FastMath, MatchesTheStandardLibraryToTheSeventhDigit) {
  for (int i = 0; i <= kNumbers; ++i) {
    const float u = static_cast<float>(i) / kNumbers;
    const float x = 200.F * u - 100.F;
    EXPECT_NEAR(fast_exp2(x) / std::exp2(double{x}), 1.0, 4e-7) << x;
    const float angle = (u - 0.5F) * (0.5F * kPi);
    EXPECT_NEAR(fast_sin(angle), std::sin(double{angle}), 4e-7) << angle;
    EXPECT_NEAR(fast_cos(angle), std::cos(double{angle}), 4e-7) << angle;
    const float tiny = std::exp2(-40.F * u);
    const double logarithm = std::log(double{tiny});
    EXPECT_NEAR(fast_log(tiny), logarithm, 4e-7 * std::max(1.0, -logarithm)) << tiny;
  }
  EXPECT_EQ(fast_exp2(0.F), 1.F);
  EXPECT_EQ(fast_log(1.F), 0.F);
}

}  // namespace
}  // namespace ajar
