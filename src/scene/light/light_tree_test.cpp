#include "scene/light/light_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "scene/light/lamps_test_support.h"

namespace ajar {
namespace {

using namespace testing;

std::vector<LightTree::Item> items_of(const Lamps& lamps) {
  std::vector<LightTree::Item> items;
  for (const auto& light : lamps.lights) items.push_back({*light->bounds(), light->index});
  return items;
}

std::vector<double> probabilities(const LightTree& tree, std::size_t lights, const Vec3& at) {
  std::vector<double> result;
  for (std::uint32_t i = 0; i < lights; ++i) {
    result.push_back(static_cast<double>(tree.probability(at, i)));
  }
  return result;
}

/// Probabilities add up to one, and choices are made with exactly these.
void expect_is_distribution(const LightTree& tree, std::size_t lights, const Vec3& at, Rng& rng) {
  const std::vector<double> p = probabilities(tree, lights, at);
  ASSERT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1.0, 1e-5);
  for (const float u : {0.F, rng.next(), rng.next(), rng.next(), kOneMinusEpsilon}) {
    const LightTree::Choice choice = tree.choose(at, u);
    ASSERT_LT(choice.light, lights);
    ASSERT_GT(choice.probability, 0.F);
    ASSERT_EQ(static_cast<double>(choice.probability), p[choice.light]);
    ASSERT_GE(choice.u, 0.F);
    ASSERT_LT(choice.u, 1.F);
  }
}

LightTree::Item point_item(const Vec3& p, float intensity, std::uint32_t light) {
  return {point_bounds(p, intensity), light};
}

TEST(LightTree, IsADistributionForAnyLightsAndReferences) {
  Rng rng(1);
  for (int scene = 0; scene < 60; ++scene) {
    const Lamps lamps = random_lamps(rng, 1 + 3 * scene, 3.F);
    const LightTree tree(items_of(lamps));
    for (const float reach : {0.5F, 3.F, 10.F, 1e4F}) {
      for (int i = 0; i < 5; ++i) {
        expect_is_distribution(tree, lamps.lights.size(), random_point(rng, reach), rng);
      }
    }
  }
}

// Power: with 400000 samples a light of probability 1/50 that is chosen 6 % too often or too rarely
// is seen.
TEST(LightTree, FrequenciesMatchItsProbabilities) {
  Rng rng(2);
  const Lamps lamps = random_lamps(rng, 50, 3.F);
  const LightTree tree(items_of(lamps));
  constexpr int kSamples = 400000;
  for (int k = 0; k < 4; ++k) {
    const Vec3 at = random_point(rng, 4.F);
    std::vector<double> counts(lamps.lights.size());
    for (int i = 0; i < kSamples; ++i) counts[tree.choose(at, rng.next()).light] += 1.0;
    std::vector<double> expected = probabilities(tree, lamps.lights.size(), at);
    for (double& e : expected) e *= kSamples;
    expect_fits(counts, expected);
  }
}

TEST(LightTree, CanChooseEveryLightThatReachesTheReference) {
  Rng rng(3);
  int reached = 0;
  int out_of_reach = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const Lamps lamps = random_lamps(rng, 120, 3.F);
    const LightTree tree(items_of(lamps));
    for (int i = 0; i < 40; ++i) {
      const Vec3 at = random_point(rng, 4.F);
      for (const auto& light : lamps.lights) {
        const bool possible = tree.probability(at, light->index) > 0.F;
        out_of_reach += possible ? 0 : 1;
        for (int k = 0; k < 3; ++k) {
          if (!light->sample_connection(at, connection_uniforms(rng))) continue;
          ++reached;
          ASSERT_TRUE(possible) << "light " << light->index << " of scene " << scene;
        }
      }
    }
  }
  EXPECT_GT(reached, 200000);
  EXPECT_GT(out_of_reach, 20000) << "the bounds tell nothing";
}

TEST(LightTree, DoesNotChooseLightsThatFaceAway) {
  const auto quad = [](float z, const Vec3& u, const Vec3& v) {
    return std::make_unique<Quad>(Vec3(-0.5F, -0.5F, z), u, v);
  };
  const Vec3 x(1.F, 0.F, 0.F);
  const Vec3 y(0.F, 1.F, 0.F);
  Lamps lamps;
  lamps.add(quad(0.F, x, y), area_light({1, 1, 1}));   // toward +z
  lamps.add(quad(0.1F, y, x), area_light({1, 1, 1}));  // toward −z
  lamps.add(quad(0.05F, y, x), area_light({1, 1, 1}, true));
  const LightTree tree(items_of(lamps));
  // Quads that share a node are separated one level below: the rest need not be even.
  const std::vector<double> above = probabilities(tree, 3, {0.2F, 0.1F, 5.F});
  EXPECT_GT(above[0], 0.3);
  EXPECT_EQ(above[1], 0.0);
  EXPECT_GT(above[2], 0.3);
  const std::vector<double> below = probabilities(tree, 3, {0.2F, 0.1F, -5.F});
  EXPECT_EQ(below[0], 0.0);
  EXPECT_GT(below[1], 0.3);
  EXPECT_GT(below[2], 0.3);
}

TEST(LightTree, PrefersNearLights) {
  const LightTree tree({point_item({0, 0, 0}, 1.F, 0), point_item({10, 0, 0}, 1.F, 1)});
  EXPECT_NEAR(tree.probability({1, 0, 0}, 0), 81.0 / 82.0, 1e-4);
  EXPECT_NEAR(tree.probability({5, 3, 0}, 0), 0.5, 1e-6);
  EXPECT_NEAR(tree.irradiance({5, 3000, 0}), 2.0 / 9e6, 1e-9);
}

TEST(LightTree, ChoosesByIntensityWhereAllAreInOnePlace) {
  Rng rng(4);
  std::vector<LightTree::Item> items;
  for (std::uint32_t i = 0; i < 5000; ++i) items.push_back(point_item({1, 2, 3}, 2.F, i));
  items.push_back(point_item({1, 2, 3}, 10000.F, 5000));
  const LightTree tree(items);
  for (const Vec3& at : {Vec3(1, 2, 3), Vec3(1.5F, 2, 3), Vec3(-1e6F, 0, 1)}) {
    expect_is_distribution(tree, items.size(), at, rng);
    EXPECT_NEAR(tree.probability(at, 17), 1e-4, 1e-7);
    EXPECT_NEAR(tree.probability(at, 5000), 0.5, 1e-3);
  }
}

TEST(LightTree, SurvivesRowsThatSplitUnevenly) {
  Rng rng(5);
  std::vector<LightTree::Item> items;
  for (std::uint32_t i = 0; i < 120; ++i) {
    const auto power = -static_cast<float>(i);
    items.push_back(point_item({std::exp2(power), 0, 0}, std::exp2(power), i));
  }
  const LightTree tree(items);
  for (int i = 0; i < 120; i += 7) {
    const auto power = -static_cast<float>(i);
    expect_is_distribution(tree, items.size(), {std::exp2(power), 1e-3F, 0}, rng);
  }
}

TEST(LightTree, FallsBackToIntensityWhereAllImportancesAreZero) {
  Rng rng(6);
  const Vec3 x(1.F, 0.F, 0.F);
  const Vec3 y(0.F, 1.F, 0.F);
  Lamps lamps;
  lamps.add(std::make_unique<Quad>(Vec3(0.F), x, y), area_light({1, 1, 1}));
  lamps.add(std::make_unique<Quad>(Vec3(3.F, 0.F, 0.F), x, y), area_light({3, 3, 3}));
  const LightTree tree(items_of(lamps));
  const Vec3 behind(1.F, 1.F, -4.F);
  expect_is_distribution(tree, 2, behind, rng);
  EXPECT_NEAR(tree.probability(behind, 1), 0.75, 1e-6);
  EXPECT_EQ(tree.irradiance(behind), 0.0);
}

TEST(LightTree, HasZeroProbabilityForOtherLights) {
  const LightTree tree({point_item({0, 0, 0}, 1.F, 2)});
  EXPECT_EQ(tree.probability({1, 1, 1}, 0), 0.F);
  EXPECT_EQ(tree.probability({1, 1, 1}, 2), 1.F);
  EXPECT_EQ(tree.probability({1, 1, 1}, 3), 0.F);
  EXPECT_TRUE(LightTree().empty());
  EXPECT_TRUE(LightTree(std::vector<LightTree::Item>()).empty());
}

}  // namespace
}  // namespace ajar
