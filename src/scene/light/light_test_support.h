#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "core/warnings.h"
#include "scene/desc/models.h"
#include "scene/light/light.h"
#include "scene/testing/emitters.h"
#include "scene/testing/endpoint_checks.h"
#include "scene/testing/transforms.h"

namespace ajar::testing {

inline const BoundingSphere kBounds{{0.5F, -0.5F, 0.25F}, 4.F};

inline desc::Node point_node(const Vec3& intensity) {
  return desc::light_node("point", {{"intensity", intensity}});
}
inline desc::Node spot_node(const Vec3& intensity, float cone_angle, float falloff_start) {
  return desc::light_node(
      "spot",
      {{"intensity", intensity}, {"cone_angle", cone_angle}, {"falloff_start", falloff_start}});
}
inline desc::Node distant_node(const Vec3& irradiance) {
  return desc::light_node("distant", {{"irradiance", irradiance}});
}
inline desc::Node environment_node(const Vec3& radiance, const std::string& image = "") {
  return desc::light_node("environment", {{"radiance", radiance}, {"image", image}});
}
inline desc::Node goniometric_node(const Vec3& intensity, const std::string& image = "") {
  return desc::light_node("goniometric", {{"intensity", intensity}, {"image", image}});
}
inline desc::Node projection_node(const Vec3& intensity, float fov, const std::string& image = "") {
  return desc::light_node("projection", {{"intensity", intensity}, {"fov", fov}, {"image", image}});
}

inline std::unique_ptr<Light> light_of(const desc::Node& node, const Mat4& to_world) {
  Warnings warnings;
  desc::Light light;
  light.to_world = to_world;
  light.node = node;
  auto result = make_light(light, kBounds, warnings);
  EXPECT_EQ(warnings.count(), 0U);
  return result;
}

/// By next event estimation, at a point, average over lanes.
inline Mean connected_irradiance(const Light& light, const Vec3& p, const Vec3& normal,
                                 int samples = 400000) {
  Rng rng(11);
  Mean mean;
  for (int i = 0; i < samples; ++i) {
    const auto sample = light.sample_connection(p, connection_uniforms(rng));
    mean.add(sample ? sample->weight.average() * std::max(0.F, dot(sample->w, normal)) : 0.0);
  }
  return mean;
}

/// By counting the emitted rays that meet the front of `patch`.
inline Mean emitted_irradiance(const Light& light, const Quad& patch, int samples) {
  Rng rng(12);
  Mean mean;
  for (int i = 0; i < samples; ++i) {
    const auto ray = light.sample_emission(emission_uniforms(rng));
    const bool hit =
        ray && dot(ray->w, patch.normal()) < 0.F && patch.intersect(ray->origin, ray->w);
    mean.add(hit ? ray->weight.average() / patch.area() : 0.0);
  }
  return mean;
}

/// Square with the given side around p.
inline Quad small_patch(const Vec3& p, const Vec3& normal, float side) {
  const Frame frame = Frame::around(normal);
  const Vec3 x = frame.x * side;
  const Vec3 y = frame.y * side;
  return {p - (x + y) * 0.5F, x, y};
}

inline Mean emitted_power(const Light& light, int samples = 400000) {
  Rng rng(13);
  Mean mean;
  for (int i = 0; i < samples; ++i) {
    const auto ray = light.sample_emission(emission_uniforms(rng));
    mean.add(ray ? ray->weight.average() : 0.0);
  }
  return mean;
}

/// Mean irradiance of `patch` both ways.
inline void expect_patch_agrees(const Light& light, const Quad& patch, int samples = 1000000,
                                double power = 0.1) {
  Rng rng(14);
  Mean connected;
  for (int i = 0; i < samples; ++i) {
    const SurfacePoint at = patch.at(next_pair(rng));
    const auto sample = light.sample_connection(at.p, connection_uniforms(rng));
    connected.add(sample ? sample->weight.average() * std::max(0.F, dot(sample->w, at.ng)) : 0.0);
  }
  expect_same_mean(emitted_irradiance(light, patch, samples), connected, power);
}

/// Rays from infinity cross the disk outside of the bounding sphere evenly.
inline void expect_disk_is_uniform(const Light& light) {
  Rng rng(15);
  constexpr int kRings = 8;
  constexpr int kSectors = 12;
  constexpr int kSamples = 100000;
  const float fixed_x = rng.next();
  const Vec2 direction(fixed_x, rng.next());
  std::vector<double> counts(kRings * kSectors);
  std::vector<double> expected(counts.size(), static_cast<double>(kSamples) / (kRings * kSectors));
  for (int i = 0; i < kSamples; ++i) {
    const auto ray = light.sample_emission({0.5F, next_pair(rng), direction});
    ASSERT_TRUE(ray);
    const Frame frame = Frame::around(ray->point.toward);
    const Vec3 local = frame.to_local(ray->origin - kBounds.center);
    ASSERT_GE(local.z, kBounds.radius);
    const double ring = (local.x * local.x + local.y * local.y) / (kBounds.radius * kBounds.radius);
    ASSERT_LT(ring, 1.0001);
    const double sector = std::atan2(local.y, local.x) / (2.0 * M_PI) + 0.5;
    const int r = std::min(static_cast<int>(ring * kRings), kRings - 1);
    const int s = std::min(static_cast<int>(sector * kSectors), kSectors - 1);
    const int cell = r * kSectors + s;
    counts[static_cast<std::size_t>(cell)] += 1.0;
    ASSERT_NEAR(ray->departure_pdf.value(), 1.0 / (M_PI * kBounds.radius * kBounds.radius), 1e-6);
  }
  expect_fits(counts, expected);
}

}  // namespace ajar::testing
