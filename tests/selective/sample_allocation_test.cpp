#include "integrator/selective/sample_allocation.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar {
namespace {

/// One mutation per pixel and sample, until the effort is shared. Two replicates.
class SampleAllocationTest : public ::testing::Test {
 protected:
  explicit SampleAllocationTest(const std::string& objective = "filtered")
      : scene_(test::scene_from(test::small_scene("Room").text)),
        prepared_(
            SelectiveConfig(*scene_, test::settings_of(*scene_, {.replicates = 2, .max_depth = 6}),
                            Parameters(SelectiveConfig::parameters(), {{"objective", objective}}))),
        pixels_(prepared_.pixels()),
        effort_(prepared_) {
    prepared_.mutations = 1.0;
    EXPECT_FALSE(effort_.can_adjust()) << "nothing was done yet";
    effort_.count_omc(4000, 1000);
    EXPECT_FALSE(effort_.can_adjust()) << "there were no chains yet";
    effort_.count_chains(4000, 1000);
    EXPECT_TRUE(effort_.can_adjust());
  }
  WeightedErrors errors(double variance) const {
    return {std::vector<double>(pixels_, variance), std::vector<double>(pixels_, 1.0)};
  }
  /// Per pixel and sample, after the effort has been shared at `samples`.
  double mutations_after(std::uint64_t samples) const {
    return effort_.mutations(samples + 1) - effort_.mutations(samples);
  }
  /// If chains are far off in one pixel of a hundred, and all have noise of ordinary Monte Carlo.
  double mutations_with_few_bad_pixels() {
    const WeightedErrors of_omc = errors(1.0);
    WeightedErrors of_chains = errors(0.0);
    // More than are left out of sums of squares.
    for (std::size_t i = 0; i < pixels_ / 100; ++i) of_chains.variance[i] = 1e4;
    effort_.adjust(16, of_omc, of_chains);
    return mutations_after(16);
  }
  std::unique_ptr<Scene> scene_;
  SelectivePreparation prepared_;
  std::size_t pixels_;
  SampleAllocation effort_;
};

class SampleAllocationOfRawPictures : public SampleAllocationTest {
 protected:
  SampleAllocationOfRawPictures() : SampleAllocationTest("raw") {}
};

TEST_F(SampleAllocationOfRawPictures, IsForTheLeastSquaredError) {
  EXPECT_GT(mutations_with_few_bad_pixels(), 2.0);
}

TEST_F(SampleAllocationTest, IsForTheLeastThatCanBeSeen) {
  EXPECT_LT(mutations_with_few_bad_pixels(), 0.5);
}

TEST_F(SampleAllocationTest, GivesReplicatesTheirShares) {
  constexpr std::size_t kChains = 4;
  const std::uint64_t usual = effort_.steps(7, kChains, 1.0);
  EXPECT_NEAR(static_cast<double>(usual), static_cast<double>(pixels_) / 2 / kChains, 1.0);
  EXPECT_NEAR(static_cast<double>(effort_.steps(7, kChains, 1.9)), 1.9 * static_cast<double>(usual),
              2.0);
  EXPECT_EQ(effort_.steps(7, kChains, 0.0), 1U) << "chains stay on the move";
}

}  // namespace
}  // namespace ajar
