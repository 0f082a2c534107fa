#include "import/pbrt/cloud.h"

#include <algorithm>

#include "import/pbrt/v4_test_support.h"

namespace ajar::pbrt {
namespace {

TEST(PbrtCloud, IsDenseBelowAndEndsAbove) {
  const Cloud cloud;
  for (float x = 0.05F; x < 1.F; x += 0.1F) {
    EXPECT_EQ(cloud.at({x, 0.F, 0.3F}), 1.F);
    EXPECT_GE(cloud.at({x, 0.25F, 0.3F}), 0.5F);
    EXPECT_EQ(cloud.at({x, 1.F, 0.3F}), 0.F);
  }
}

TEST(PbrtCloud, HasTheNoiseAloneInTheUpperHalfWithoutWisps) {
  // Noise is 0 at the origin, which is where the frequency 0 has all points.
  Cloud cloud;
  cloud.wispiness = 0.F;
  cloud.frequency = 0.F;
  EXPECT_EQ(cloud.at({0.3F, 0.75F, 0.3F}), 0.F);
  cloud.frequency = 4.F;
  cloud.density = 100.F;
  float least = 1.F;
  float most = 0.F;
  for (float x = 0.F; x < 1.F; x += 0.01F) {
    least = std::min(least, cloud.at({x, 0.75F, 0.3F}));
    most = std::max(most, cloud.at({x, 0.75F, 0.3F}));
  }
  EXPECT_EQ(least, 0.F);
  EXPECT_EQ(most, 1.F);
}

TEST(PbrtCloud, IsInTheGridAsItIs) {
  Cloud cloud;
  cloud.low = {-1, 0.25F, 0};
  cloud.high = {0, 0.75F, 0.5F};
  cloud.frequency = 2.F;
  const desc::DensityGrid grid = tabulate(cloud, CloudGrids::kMostPoints);
  // 2 · 2 · 1.99⁴ = 62.7 cells in a unit.
  EXPECT_EQ(grid.resolution, desc::Vec3i(64, 33, 33));
  EXPECT_EQ(grid.values.front(), cloud.at(cloud.low));
  EXPECT_NEAR(grid.values.back(), cloud.at(cloud.high), 1e-4F);
  const std::size_t middle = (16U * 33U + 8U) * 64U + 21U;
  EXPECT_NEAR(grid.values[middle], cloud.at({-1 + 21.F / 63.F, 0.25F + 8.F / 64.F, 0.25F}), 1e-3F);
}

TEST(PbrtCloud, OfFinerNoiseIsCoarserWithAWarning) {
  const std::string medium = "MakeNamedMedium \"m\" \"string type\" \"cloud\" ";
  const desc::SceneDesc usual = v4_scene(medium + "\"float density\" 2 \"float frequency\" 1");
  EXPECT_EQ(usual.media.at(0).density->grid->resolution, desc::Vec3i(33));
  const std::string text = v4_warnings(medium + "\"float frequency\" 10 \"point p1\" [1 .01 .01]");
  EXPECT_TRUE(contains(text, "test.pbrt:2:1: the noise of this cloud is finer")) << text;
}

/// A cloud of 256³ points, alone.
Cloud fine_cloud(float density) {
  Cloud cloud;
  cloud.density = density;
  cloud.frequency = 1000.F;
  return cloud;
}

TEST(PbrtCloud, AloneInItsFileIsAsFineAsGridsMayBe) {
  const Cloud cloud = fine_cloud(1.F);
  EXPECT_EQ(lattice_of(cloud, CloudGrids::kMostPoints / 2), desc::Vec3i(256));
  EXPECT_EQ(lattice_of(cloud, CloudGrids::kMostPoints / 2 - 1), desc::Vec3i(255));
  EXPECT_EQ(lattice_of(cloud, 0), desc::Vec3i(2));
}

TEST(PbrtCloud, OfWhichThereAreManyAreCoarserOneByOne) {
  constexpr std::uint64_t kBudget = 1U << 15U;
  constexpr std::uint64_t kClouds = 100;
  CloudGrids grids(kBudget);
  Warnings warnings;
  std::uint64_t sum = 0;
  std::size_t before = kBudget / 2;
  for (std::uint64_t i = 0; i < kClouds; ++i) {
    const auto grid = grids.get(fine_cloud(static_cast<float>(i)), {}, "cloud", warnings);
    sum += grid->values.size();
    EXPECT_LE(grid->values.size(), before) << i;
    before = grid->values.size();
  }
  EXPECT_LE(sum, kBudget + 8 * kClouds);
  EXPECT_GT(sum, kBudget / 2);
  EXPECT_EQ(warnings.count(), kClouds);
}

TEST(PbrtCloud, TwiceInAFileHasOneGrid) {
  const std::string cloud = "\"string type\" \"cloud\" \"float frequency\" 0.2 \"float density\" ";
  const desc::SceneDesc scene =
      v4_scene("MakeNamedMedium \"a\" " + cloud + "2\nMakeNamedMedium \"b\" " + cloud +
               "3\nTranslate 1 2 3 MakeNamedMedium \"c\" " + cloud + "2");
  const auto grid = [&](std::size_t i) { return scene.media.at(i).density->grid; };
  EXPECT_EQ(grid(0), grid(2));
  EXPECT_NE(grid(0), grid(1));
  EXPECT_NE(scene.media[0].density->to_world, scene.media[2].density->to_world);
}

}  // namespace
}  // namespace ajar::pbrt
