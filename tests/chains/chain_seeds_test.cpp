#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "support/render.h"
#include "support/stripes.h"

/// Seeds of unequal weight start several chains each, in proportion. All must walk equally far:
/// light would otherwise leave bright places faster than it comes back from dark ones.
namespace ajar {
namespace {

/// Ratio of the dark stripes to kDark / kBright of the bright ones, over independent renders.
struct Excess {
  double mean = 0.0;  ///< over the expected value
  double error = 0.0;
};

Excess excess_of_dark_stripes(const Scene& scene, test::RenderOptions options, int renders) {
  double sum = 0.0;
  double squares = 0.0;
  double expected = 0.0;
  for (int i = 0; i < renders; ++i) {
    options.seed = static_cast<std::uint64_t>(i) + 1;
    const test::Render render = test::render(scene, options);
    const std::vector<float> image = render.image();
    const auto width = static_cast<std::size_t>(render.film->width());
    double bright = 0.0;
    double dark = 0.0;
    for (std::size_t p = 0; p < image.size() / 3; ++p) {
      (p % width % 2 == 0 ? bright : dark) += static_cast<double>(image[3 * p]);
    }
    const double ratio = static_cast<double>(test::kDark) / static_cast<double>(test::kBright);
    const double excess = dark - ratio * bright;
    expected += ratio * bright;
    sum += excess;
    squares += excess * excess;
  }
  expected /= renders;
  const double mean = sum / renders;
  const double variance = (squares / renders - mean * mean) / (renders - 1);
  return {mean / expected, std::sqrt(variance) / expected};
}

void expect_none(const Excess& excess, double noticed) {
  EXPECT_LT(5.0 * excess.error, noticed) << "too noisy to notice what it is for";
  EXPECT_LT(std::abs(excess.mean), 5.0 * excess.error);
}

test::RenderOptions options_of_chains() {
  test::RenderOptions options;
  options.integrator = "mmlt";
  options.min_depth = 3;
  options.parameters = {{"large-step", "0.02"}};
  return options;
}

// Twenty chains start from each bright sample, and hardly one from a dark one. When one chain with
// twenty times the steps stood for them, the dark stripes were 0.9 too bright.
TEST(SeedsOfUnequalWeight, WalkEquallyFarFromABootstrap) {
  const auto scene = test::stripes(
      16, 12,
      "LightSource \"point\" \"point from\" [0 12 -6] \"rgb I\" [100 100 100]\n"
      "AttributeBegin Material \"matte\" \"rgb Kd\" [0.7 0.7 0.7] ReverseOrientation\n"
      "Shape \"sphere\" \"float radius\" [30] AttributeEnd\n");
  test::RenderOptions options = options_of_chains();
  options.max_depth = 3;
  options.samples = 1;
  options.replicates = 1;
  options.parameters["bootstrap"] = "1000";
  options.parameters["chains"] = "20000";
  expect_none(excess_of_dark_stripes(*scene, options, 20), 0.3);
}

}  // namespace
}  // namespace ajar
