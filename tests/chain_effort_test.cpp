#include "integrator/chain_effort.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "integrator/chain_family.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// How a render shares its effort between its halves.
namespace ajar {
namespace {

/// Mutations per pixel and sample after 16 samples, if chains are far off in one pixel of a
/// hundred, and all have noise of ordinary Monte Carlo.
double mutations_with_few_bad_pixels(bool by_eye) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  ChainPlan plan(ChainKind::OnePath, *scene,
                 test::settings_of(*scene, {.replicates = 2, .max_depth = 6}),
                 Parameters(chain_parameters(ChainKind::OnePath), {}), {});
  plan.shares_effort = true;
  plan.mutations = 1.0;
  ChainEffort effort(plan);
  EXPECT_FALSE(effort.can_adjust()) << "nothing was done yet";
  effort.count_omc(4000, 1000);
  EXPECT_FALSE(effort.can_adjust()) << "there were no chains yet";
  effort.count_chains(4000, 1000);
  EXPECT_TRUE(effort.can_adjust());
  const std::size_t pixels = plan.pixels();
  WeightedErrors of_omc{std::vector<double>(pixels, 1.0), std::vector<double>(pixels, 1.0)};
  WeightedErrors of_chains{std::vector<double>(pixels, 0.0), std::vector<double>(pixels, 1.0)};
  // More than are left out of sums of squares.
  for (std::size_t i = 0; i < pixels / 100; ++i) of_chains.variance[i] = 1e4;
  // As the eye has it.
  const auto seen = [](const WeightedErrors& errors) {
    std::vector<std::vector<float>> pictures(2);
    for (const double variance : errors.variance) {
      pictures[0].push_back(static_cast<float>(std::sqrt(variance)));
      pictures[1].push_back(-pictures[0].back());
    }
    return pictures;
  };
  effort.adjust(16, of_omc, of_chains,
                by_eye ? std::optional<ChainEffort::Seen>({seen(of_omc), seen(of_chains), 16, 16})
                       : std::nullopt);
  return effort.mutations(17) - effort.mutations(16);
}

TEST(ChainEffort, IsForTheLeastSquaredError) {
  EXPECT_GT(mutations_with_few_bad_pixels(false), 2.0);
}

TEST(ChainEffort, IsForTheLeastThatCanBeSeen) {
  EXPECT_LT(mutations_with_few_bad_pixels(true), 0.5);
}

}  // namespace
}  // namespace ajar
