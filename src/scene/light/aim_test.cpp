#include "scene/light/aim.h"

#include <gtest/gtest.h>

#include "scene/light/light_test_support.h"
#include "scene/light/models.h"

/// Lamps aimed at their receivers, at several distances from them.
namespace ajar {
namespace {

using namespace testing;

constexpr BoundingSphere kReceivers{Vec3(0.F, 0.F, 0.F), 1.F};
/// From a cone of nearly 60° to one that is narrower than any that is aimed at.
const std::vector<float> kDistances = {1.2F, 3.F, 30.F, 10000.F};

struct AimedLamp {
  std::string name;
  std::unique_ptr<SurfaceSampler> surface;
  std::unique_ptr<Light> light;
  double power;
};

AimedLamp on_surface(const std::string& name, std::unique_ptr<SurfaceSampler> surface,
                     bool two_sided, const std::optional<BoundingSphere>& receivers) {
  const double power = M_PI * double{surface->area()} * (two_sided ? 2.0 : 1.0);
  auto light = make_surface_light(area_light({1, 1, 1}, two_sided), *surface, {}, receivers);
  return {name, std::move(surface), std::move(light), power};
}

/// Lamps around (0, 0, −distance), which shine toward +z, in part aslant.
std::vector<AimedLamp> lamps_at(float distance, const std::optional<BoundingSphere>& receivers) {
  const Vec3 p(0.F, 0.F, -distance);
  std::vector<AimedLamp> lamps;
  lamps.push_back({"point", nullptr,
                   make_point_light(Spectrum(1.F), {p, DirectionMap()}, Aim(receivers)),
                   4.0 * M_PI});
  for (const bool two_sided : {false, true}) {
    lamps.push_back(
        on_surface("quad", std::make_unique<Quad>(p, Vec3(0.1F, 0.F, 0.F), Vec3(0.F, 0.1F, 0.04F)),
                   two_sided, receivers));
  }
  lamps.push_back(on_surface("ball", std::make_unique<Ball>(p, 0.1F), false, receivers));
  return lamps;
}

TEST(Aim, WeightsAndDensitiesAgree) {
  for (const float distance : kDistances) {
    for (const AimedLamp& lamp : lamps_at(distance, kReceivers)) {
      SCOPED_TRACE(lamp.name + " at " + std::to_string(distance));
      check_emission(*lamp.light);
    }
  }
}

TEST(Aim, DeparturesFollowTheirDensity) {
  for (const float distance : {1.2F, 3.F}) {
    for (const AimedLamp& lamp : lamps_at(distance, kReceivers)) {
      SCOPED_TRACE(lamp.name + " at " + std::to_string(distance));
      check_departures(*lamp.light, cone_chart({0.F, 0.F, 1.F}), 32, 16);
    }
  }
}

TEST(Aim, LosesNoLight) {
  for (const float distance : kDistances) {
    for (const AimedLamp& lamp : lamps_at(distance, kReceivers)) {
      SCOPED_TRACE(lamp.name + " at " + std::to_string(distance));
      expect_mean(emitted_power(*lamp.light), lamp.power, 0.1);
    }
  }
}

TEST(Aim, LightsReceiversAsConnectionsDo) {
  const Quad patch = small_patch({0.2F, 0.1F, 0.3F}, normalize(Vec3(0.2F, 0.1F, -1.F)), 0.5F);
  for (const float distance : {1.2F, 30.F}) {
    for (const AimedLamp& lamp : lamps_at(distance, kReceivers)) {
      SCOPED_TRACE(lamp.name + " at " + std::to_string(distance));
      expect_patch_agrees(*lamp.light, patch, 400000);
    }
  }
}

TEST(Aim, SendsNearlyAllRaysToTheReceivers) {
  for (const AimedLamp& lamp : lamps_at(30.F, kReceivers)) {
    SCOPED_TRACE(lamp.name);
    Rng rng(5);
    int met = 0;
    constexpr int kRays = 10000;
    for (int i = 0; i < kRays; ++i) {
      const auto ray = lamp.light->sample_emission(emission_uniforms(rng));
      if (ray && length(cross(ray->w, kReceivers.center - ray->origin)) < 1.F) ++met;
    }
    // Half of the ball's points face the other way.
    EXPECT_GT(met, lamp.name == "ball" ? 0.45 * kRays : 0.93 * kRays);
  }
}

TEST(Aim, LeavesLampsAmongTheReceiversAsTheyAre) {
  const auto aimed = lamps_at(0.9F, kReceivers);
  const auto plain = lamps_at(0.9F, std::nullopt);
  Rng rng(6);
  for (std::size_t i = 0; i < aimed.size(); ++i) {
    for (int k = 0; k < 100; ++k) {
      const EmissionUniforms u = emission_uniforms(rng);
      const auto a = aimed[i].light->sample_emission(u);
      const auto b = plain[i].light->sample_emission(u);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (a) {
        EXPECT_EQ(a->w, b->w);
      }
    }
  }
}

}  // namespace
}  // namespace ajar
