#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/metrics.h"
#include "support/render.h"

/// No seed is to be unlucky: a path that was found once must not outshine the light around it.
/// studies/seeds-agree.json tests more seeds and scenes.
namespace ajar {
namespace {

using Pixels = std::vector<float>;

Pixels mean_of_others(const std::vector<Pixels>& pictures, std::size_t but) {
  Pixels mean(pictures.front().size(), 0.F);
  for (std::size_t p = 0; p < pictures.size(); ++p) {
    if (p == but) continue;
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += pictures[p][i];
  }
  for (float& value : mean) value /= static_cast<float>(pictures.size() - 1);
  return mean;
}

/// Chains that lead to the torus by the rounded edges of the glass are found once in thousands of
/// guesses. As seeds of that weight, they left a glowing streak on it in one seed of these eight,
/// with nine times the error of the others.
TEST(SeedsOfSelective, AgreeAboutLightThroughTheEdgesOfGlass) {
  constexpr std::uint64_t kFirst = 9;
  constexpr std::size_t kSeeds = 8;
  const Scene scene = test::builtin_scene("torus-in-glass");
  test::RenderOptions options;
  options.integrator = "selective";
  options.samples = 24;
  options.replicates = 4;
  options.max_depth = 24;
  std::vector<Pixels> pictures;
  for (std::size_t i = 0; i < kSeeds; ++i) {
    options.seed = kFirst + i;
    pictures.push_back(test::render(scene, options).image());
  }
  std::vector<double> errors;
  for (std::size_t i = 0; i < kSeeds; ++i) {
    errors.push_back(relative_mse_at_scale(pictures[i], mean_of_others(pictures, i),
                                           scene.camera().resolution(), 4.0));
  }
  std::sort(errors.begin(), errors.end());
  const double median = 0.5 * (errors[kSeeds / 2 - 1] + errors[kSeeds / 2]);
  EXPECT_LT(errors.back(), 3.0 * median);
}

}  // namespace
}  // namespace ajar
