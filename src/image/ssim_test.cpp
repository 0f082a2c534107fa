#include "image/ssim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "image/testing/pattern.h"

namespace ajar {
namespace {

using testing_images::kPatternSize;
using testing_images::pattern;

TEST(Ssim, OfEqualImagesIsOne) {
  EXPECT_DOUBLE_EQ(ssim(pattern(1), pattern(1), kPatternSize).value(), 1.0);
}

// The numbers come from NumPy: the formula of the docstring, window by window, with the weights as
// a two-dimensional array and moments about the windows' means.
TEST(Ssim, MatchesAnIndependentImplementation) {
  EXPECT_NEAR(ssim(pattern(1), pattern(0), kPatternSize).value(), -0.032172840659902016, 1e-6);
  std::vector<float> brighter = pattern(0);
  for (float& v : brighter) v = std::min(v + 0.1F, 1.F);
  EXPECT_NEAR(ssim(brighter, pattern(0), kPatternSize).value(), 0.9826760598443653, 1e-6);
}

TEST(Ssim, NeedsAWholeWindow) {
  const std::vector<float> grey(3 * 11 * 10, 0.5F);
  EXPECT_FALSE(ssim(grey, grey, {11, 10}));
  EXPECT_THROW(ssim(grey, grey, {11, 11}), std::invalid_argument);
}

}  // namespace
}  // namespace ajar
