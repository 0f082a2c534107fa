#include "scene/light/light_sampler.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/light/light_test_support.h"

namespace ajar {
namespace {

using namespace testing;

LightList point_lights(const std::vector<float>& intensities) {
  LightList lights;
  for (const float intensity : intensities) {
    lights.push_back(light_of(desc::PointLight{{intensity, intensity, intensity}}, Mat4()));
    lights.back()->index = static_cast<std::uint32_t>(lights.size() - 1);
  }
  return lights;
}

TEST(LightSampler, ChoosesByPower) {
  const LightList lights = point_lights({1.F, 0.F, 2.F, 5.F});
  const LightSampler sampler(lights);
  EXPECT_FALSE(sampler.empty());
  std::vector<double> counts(4);
  Rng rng(1);
  constexpr int kSamples = 100000;
  for (int i = 0; i < kSamples; ++i) {
    const float u = rng.next();
    const ChosenLight chosen = sampler.choose({1, 2, 3}, u);
    ASSERT_NE(chosen.light, nullptr);
    ASSERT_EQ(chosen.probability, sampler.probability({1, 2, 3}, *chosen.light));
    ASSERT_GE(chosen.u, 0.F);
    ASSERT_LT(chosen.u, 1.F);
    const ChosenLight emitter = sampler.choose_emitter(u);
    ASSERT_EQ(emitter.probability, sampler.emitter_probability(*emitter.light));
    counts[chosen.light->index] += 1.0;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const double p = std::vector<double>{1, 0, 2, 5}[i] / 8.0;
    EXPECT_NEAR(counts[i], kSamples * p, 5.0 * std::sqrt(kSamples * p) + 1e-9);
    EXPECT_NEAR(sampler.probability({0, 0, 0}, *lights[i]).value(), p, 1e-6);
  }
}

TEST(LightSampler, AllBlackLightsAreEquallyLikely) {
  const LightList lights = point_lights({0.F, 0.F, 0.F});
  const LightSampler sampler(lights);
  for (const auto& light : lights) {
    EXPECT_NEAR(sampler.emitter_probability(*light).value(), 1.0 / 3.0, 1e-6);
  }
}

TEST(LightSampler, FaintLightsBesideAStrongOneCanBeChosen) {
  const LightList lights = point_lights({1e-20F, 1e15F, 1e-20F});
  const LightSampler sampler(lights);
  EXPECT_GT(sampler.emitter_probability(*lights[0]).value(), 0.F);
  EXPECT_GT(sampler.emitter_probability(*lights[2]).value(), 0.F);
}

TEST(LightSampler, KnowsThatThereAreNoLights) {
  const LightList none;
  EXPECT_TRUE(LightSampler(none).empty());
}

}  // namespace
}  // namespace ajar
