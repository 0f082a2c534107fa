#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

#include "color/color.h"
#include "color/daylight.h"
#include "scene/light/light_test_support.h"
#include "scene/light/map.h"
#include "scene/light/sphere_map.h"
#include "scene/testing/image_file.h"

/// Lights that are shaped by an image: environment, goniometric, projection.
namespace ajar {
namespace {

using namespace testing;

std::vector<float> random_pixels(int count, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<float> rgb;
  rgb.reserve(3 * static_cast<std::size_t>(count));
  for (int i = 0; i < 3 * count; ++i)
    rgb.push_back(rng.next() < 0.3F ? 0.F : std::exp(4.F * rng.next()));
  return rgb;
}

std::vector<float> one_bright(int width, int height, int x, int y, float value) {
  std::vector<float> rgb(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const std::size_t first = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x));
  for (std::size_t c = 0; c < 3; ++c) rgb[first + c] = value;
  return rgb;
}

/// World directions of a lat-long map, so that bins fall on its cells.
Chart<Vec3> lat_long_chart(const Mat4& to_world) {
  const Mat4 inverse = to_world.inverse();
  return {[=](const Vec2& s) { return transform_vector(to_world, lat_long::to_direction(s)); },
          [](const Vec2& s) { return 2.0 * M_PI * M_PI * std::sin(M_PI * s.y); },
          [=](const Vec3& w) { return lat_long::to_uv(transform_vector(inverse, w)); }};
}

TEST(Map, ReadsFloatImagesAsTheyAre) {
  const ImageFile file(2, 1, {0.25F, 0.5F, 3.F, 1.F, -2.F, 7.F});
  Warnings warnings;
  const Map map = load_map(file.path(), MapEdge::Clamp, {}, warnings);
  EXPECT_EQ(warnings.count(), 0U);
  EXPECT_EQ(map.lookup({0.25F, 0.5F}), Spectrum(0.25F, 0.5F, 3.F));
  EXPECT_EQ(map.lookup({0.75F, 0.5F}), Spectrum(1.F, 0.F, 7.F)) << "negative values become zero";
  EXPECT_NEAR(map.lookup({0.5F, 0.5F})[0], 0.625F, 1e-6F);
}

TEST(Map, DecodesIntegersFromSrgb) {
  const ImageFile file(1, 1, {0.5F, 0.F, 1.F}, ".png", OIIO::TypeDesc::UINT8);
  Warnings warnings;
  const Spectrum value = load_map(file.path(), MapEdge::Clamp, {}, warnings).lookup({0.5F, 0.5F});
  EXPECT_NEAR(value[0], 0.2140F, 0.003F);
  EXPECT_EQ(value[1], 0.F);
  EXPECT_FLOAT_EQ(value[2], 1.F);
}

TEST(Map, DecodesIntegersByAnExponent) {
  const ImageFile file(1, 1, {0.5F, 0.F, 1.F}, ".png", OIIO::TypeDesc::UINT8);
  const auto value = [&](float exponent) {
    desc::Node node = environment_node(Vec3(1.F), file.path());
    node.set("decoding_exponent", exponent);
    const auto light = light_of(node, Mat4());
    return light->emitted(light->at_direction({1, 0, 0}), {-1, 0, 0});
  };
  constexpr float kCode = 128.F / 255.F;
  EXPECT_NEAR(value(1.F)[0], kCode, 1e-6F);
  EXPECT_NEAR(value(2.2F)[0], std::pow(kCode, 2.2F), 1e-6F);
  EXPECT_EQ(value(2.2F)[1], 0.F);
  EXPECT_FLOAT_EQ(value(2.2F)[2], 1.F);
}

TEST(EnvironmentMap, MayTakeTheNearestTexel) {
  const ImageFile file(4, 2, {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4,  //
                              5, 5, 5, 6, 6, 6, 7, 7, 7, 8, 8, 8});
  desc::Node node = environment_node(Vec3(1.F), file.path());
  node.set("nearest", true);
  const auto light = light_of(node, Mat4());
  check_connection(*light, {{0, 0, 0}});
  for (const Vec2& uv : {Vec2(0.01F, 0.1F), Vec2(0.24F, 0.49F), Vec2(0.76F, 0.51F)}) {
    const Vec3 w = lat_long::to_direction(uv);
    const float texel = 1.F + std::floor(4.F * uv.x) + 4.F * std::floor(2.F * uv.y);
    EXPECT_EQ(light->emitted(light->at_direction(w), -w)[0], texel);
  }
}

TEST(EnvironmentMap, MayHaveItsPolesInTheFirstAndTheLastRow) {
  // One colour in each of three rows: at the pole, the equator and the other pole.
  const ImageFile file(2, 3, {1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1});
  desc::Node node = environment_node(Vec3(1.F), file.path());
  node.set("rows_at_poles", true);
  const auto light = light_of(node, Mat4());
  for (const float v : {0.001F, 0.2F, 0.5F, 0.8F}) {
    const Vec3 w = lat_long::to_direction({0.3F, v});
    const Spectrum seen = light->emitted(light->at_direction(w), -w);
    EXPECT_NEAR(seen[0], std::max(1.F - 2.F * v, 0.F), 1e-5F) << v;
    EXPECT_NEAR(seen[1], 1.F - std::abs(2.F * v - 1.F), 1e-5F) << v;
    EXPECT_NEAR(seen[2], std::max(2.F * v - 1.F, 0.F), 1e-5F) << v;
  }
  const ImageFile noise(5, 4, random_pixels(20, 3));
  desc::Node other = environment_node(Vec3(1.F), noise.path());
  other.set("rows_at_poles", true);
  check_connection(*light_of(other, Mat4()), {{0, 0, 0}});
  const ImageFile row(4, 1, {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1});
  desc::Node flat = environment_node(Vec3(1.F), row.path());
  flat.set("rows_at_poles", true);
  const auto even = light_of(flat, Mat4());
  EXPECT_NEAR(even->emitted(even->at_direction({0, 0, 1}), {0, 0, -1})[0], 1.F, 1e-6F);
}

TEST(Map, SpreadsOneChannelOverAllLanes) {
  const ImageFile file(2, 1, {0.25F, 0.5F}, ".exr", OIIO::TypeDesc::FLOAT, 1);
  Warnings warnings;
  EXPECT_EQ(load_map(file.path(), MapEdge::Clamp, {}, warnings).lookup({0.25F, 0.5F}),
            Spectrum(0.25F));
}

TEST(Map, UnreadableFilesAreMagentaAndNamedInAWarning) {
  Warnings warnings;
  const SourceLocation where{std::make_shared<std::string>("scene.pbrt"), 3, 1};
  const std::string missing = "/nonexistent/sky.exr";
  EXPECT_EQ(load_map(missing, MapEdge::Repeat, where, warnings).lookup({0.1F, 0.9F}),
            Spectrum(1, 0, 1));
  ASSERT_EQ(warnings.count(), 1U);
  EXPECT_NE(warnings.messages()[0].find(missing), std::string::npos);
  EXPECT_EQ(warnings.messages()[0].find("scene.pbrt:3:1"), 0U);
  const ImageFile file(2, 1, {1, 1, 1, 1, 1, 1});
  std::filesystem::resize_file(file.path(), 20);
  EXPECT_EQ(load_map(file.path(), MapEdge::Repeat, where, warnings).lookup({0.1F, 0.9F}),
            Spectrum(1, 0, 1));
  EXPECT_EQ(warnings.count(), 2U);
}

TEST(Map, RepeatsOrClampsAtItsSidesAndClampsAboveAndBelow) {
  const std::vector<Spectrum> texels{Spectrum(0.F), Spectrum(1.F), Spectrum(2.F), Spectrum(5.F)};
  const Map repeated(2, 2, texels, MapEdge::Repeat);
  const Map clamped(2, 2, texels, MapEdge::Clamp);
  EXPECT_NEAR(repeated.lookup({0.F, 0.F})[0], 0.5F, 1e-6F);
  EXPECT_NEAR(repeated.lookup({kOneMinusEpsilon, 0.99F})[0], 3.5F, 1e-5F);
  EXPECT_NEAR(clamped.lookup({0.F, 0.F})[0], 0.F, 1e-6F);
  EXPECT_NEAR(clamped.lookup({1.F, 1.F})[0], 5.F, 1e-6F);
}

TEST(SphereProjection, DirectionsAndCoordinatesAreInverse) {
  Rng rng(1);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 w = warp::uniform_sphere(next_pair(rng));
    EXPECT_LT(length(lat_long::to_direction(lat_long::to_uv(w)) - w), 2e-6F);
  }
  EXPECT_LT(length(lat_long::to_direction({0.F, 0.5F}) - Vec3(1, 0, 0)), 1e-6F);
  EXPECT_LT(length(lat_long::to_direction({0.25F, 0.5F}) - Vec3(0, 1, 0)), 1e-6F);
  EXPECT_LT(length(lat_long::to_direction({0.F, 0.F}) - Vec3(0, 0, 1)), 1e-6F);
}

TEST(SphereMap, DensityIsPositiveWhereverTheMapIs) {
  const ImageFile file(32, 16, one_bright(32, 16, 0, 5, 1e6F));
  Warnings warnings;
  const SphereMap map(load_map(file.path(), MapEdge::Repeat, {}, warnings),
                      sphere_projection("longitude_latitude"));
  Rng rng(2);
  int bright = 0;
  for (int i = 0; i < 200000; ++i) {
    const Vec2 uv = next_pair(rng);
    if (map.lookup(uv).is_black()) continue;
    ++bright;
    EXPECT_GT(map.pdf(uv).value(), 0.F);
  }
  EXPECT_GT(bright, 500);
}

TEST(Map, DistributionByWholeTexelsIsPositiveWhereverTheMapIs) {
  std::vector<Spectrum> texels(32 * 16, Spectrum(0.F));
  texels[5 * 32] = Spectrum(1e6F);
  const Map map(32, 16, texels, MapEdge::Repeat);
  const Distribution2D distribution = make_map_distribution(
      map, [](const Vec2& /*uv*/) { return 1.F; }, 0);
  Rng rng(2);
  Mean integral;
  for (int i = 0; i < 200000; ++i) {
    const Vec2 uv = next_pair(rng);
    if (!map.lookup(uv).is_black()) {
      EXPECT_GT(distribution.pdf(uv), 0.F);
    }
    const auto sample = distribution.sample(uv);
    integral.add(map.lookup(sample.uv)[0] / sample.pdf);
  }
  expect_mean(integral, 1e6 / (32 * 16), 0.02, 1e-3);
}

TEST(SkyLight, IsTheClearSkyAboveTheHorizonAndBlackBelow) {
  const double sun_zenith = 60.0 * M_PI / 180.0;
  const Mat4 to_world = rotation({1, 2, -0.5F}, 0.8);
  const auto light =
      light_of(desc::light_node("sky", {{"turbidity", 2.5F}, {"elevation", 30.F}, {"scale", 7.F}}),
               to_world);
  const ClearSky sky(2.5, sun_zenith);
  const Vec3d sun(std::sin(sun_zenith), 0.0, std::cos(sun_zenith));
  Rng rng(3);
  int above = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 w = warp::uniform_sphere(next_pair(rng));
    const Vec3 toward = transform_vector(to_world, w);
    const Spectrum radiance = light->emitted(light->at_direction(toward), -toward);
    if (w.z < -0.02F) {
      EXPECT_TRUE(radiance.is_black());
    }
    if (w.z < 0.02F) continue;
    ++above;
    const Vec3d rgb =
        xyz_to_rgb(sky.luminance(std::acos(double{w.z}),
                                 std::acos(std::clamp(Vec3d(w).dot(sun), -1.0, 1.0)))) *
        7.0;
    // The cusp around the sun is as narrow as a texel; elsewhere interpolation is nearly exact.
    const double tolerance = (Vec3d(w).dot(sun) > 0.999 ? 0.03 : 0.002) * rgb.y;
    EXPECT_NEAR(static_cast<double>(radiance[1]), rgb.y, tolerance)
        << w.x << " " << w.y << " " << w.z;
    EXPECT_NEAR(static_cast<double>(radiance[2]), rgb.z, tolerance * 3.0);
  }
  EXPECT_GT(above, 800);
}

TEST(SkyLight, FluxIsTheIntegralOfItsRadiance) {
  const auto light = light_of(desc::light_node("sky", {{"elevation", 50.F}}), Mat4());
  const ClearSky sky(3.0, 40.0 * M_PI / 180.0);
  const Vec3d sun(std::sin(40.0 * M_PI / 180.0), 0.0, std::cos(40.0 * M_PI / 180.0));
  // ∫ L cosθ dω by midpoints, in the mean of the lanes.
  double expected = 0.0;
  constexpr int kSteps = 300;
  for (int i = 0; i < kSteps; ++i) {
    const double zenith = (i + 0.5) / kSteps * M_PI / 2.0;
    for (int j = 0; j < kSteps; ++j) {
      const double azimuth = (j + 0.5) / kSteps * 2.0 * M_PI;
      const Vec3d w(std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth),
                    std::cos(zenith));
      const Vec3d rgb =
          xyz_to_rgb(sky.luminance(zenith, std::acos(std::clamp(w.dot(sun), -1.0, 1.0))));
      expected += (rgb.x + rgb.y + rgb.z) / 3.0 * std::sin(zenith) * std::cos(zenith);
    }
  }
  expected *= M_PI / 2.0 / kSteps * 2.0 * M_PI / kSteps;
  // Five standard errors are below 1 %: a lane or a factor of π would show.
  expect_mean(connected_irradiance(*light, {0, 0, 0}, {0, 0, 1}, 160000), expected, 0.01, 2e-3);
}

TEST(EnvironmentMap, BrightTexelShinesFromPbrtsDirection) {
  const ImageFile file(16, 8, one_bright(16, 8, 3, 2, 100.F));
  const Mat4 to_world = rotation({1, 0, 0}, -M_PI / 2) * rotation({0, 0, 1}, 0.3);
  const auto light = light_of(environment_node({1, 1, 1}, file.path()), to_world);
  const double theta = M_PI * 2.5 / 8;
  const double phi = 2 * M_PI * 3.5 / 16;
  const Vec3 local(static_cast<float>(std::sin(theta) * std::cos(phi)),
                   static_cast<float>(std::sin(theta) * std::sin(phi)),
                   static_cast<float>(std::cos(theta)));
  const Vec3 world = transform_vector(to_world, local);
  const EndpointPoint bright = light->at_direction(world);
  EXPECT_NEAR(light->emitted(bright, -world)[0], 100.F, 1e-2F);
  EXPECT_TRUE(light->emitted(light->at_direction(-world), world).is_black());
  Rng rng(3);
  for (int i = 0; i < 1000; ++i) {
    const auto sample = light->sample_connection({0, 0, 0}, connection_uniforms(rng));
    ASSERT_TRUE(sample);
    EXPECT_GT(dot(sample->w, world), std::cos(0.8F));
  }
}

TEST(EnvironmentMap, WeightsDensitiesAndIntegrals) {
  const ImageFile file(12, 6, random_pixels(72, 1));
  const Mat4 to_world = rotation({1, 2, 3}, 0.9);
  const auto light = light_of(environment_node({1, 0.5F, 2}, file.path()), to_world);
  check_emission(*light);
  check_connection(*light, {{0, 0, 0}});
  expect_disk_is_uniform(*light);
  Rng rng(4);
  const auto pdf = [&](const Vec3& w) {
    return static_cast<double>(light->connection_pdf({0, 0, 0}, light->at_direction(w)).value());
  };
  check_density<Vec3>(
      lat_long_chart(to_world),
      [&]() -> std::optional<Vec3> {
        const auto sample = light->sample_connection({0, 0, 0}, connection_uniforms(rng));
        if (!sample) return std::nullopt;
        return sample->w;
      },
      pdf, 200000, 24, 12, 12);
  check_density<Vec3>(
      lat_long_chart(to_world),
      [&]() -> std::optional<Vec3> {
        const auto sample = light->sample_emission(emission_uniforms(rng));
        if (!sample) return std::nullopt;
        return -sample->w;
      },
      pdf, 200000, 24, 12, 12);
  // Quadrature of the radiance as rays that leave the scene see it.
  double power = 0.0;
  double irradiance = 0.0;
  const Vec3 normal = normalize(Vec3(1, -1, 0.5F));
  const Chart<Vec3> sphere = cone_chart({0, 1, 0});
  constexpr int kSide = 512;
  for (int i = 0; i < kSide * kSide; ++i) {
    const int column = i % kSide;
    const int row = i / kSide;
    const Vec2 s((static_cast<float>(column) + 0.5F) / kSide,
                 (static_cast<float>(row) + 0.5F) / kSide);
    const Vec3 w = sphere.point(s);
    const double value = light->emitted(light->at_direction(w), -w).average();
    power += value * sphere.measure(s) / (kSide * kSide);
    irradiance += value * std::max(0.F, dot(w, normal)) * sphere.measure(s) / (kSide * kSide);
  }
  expect_mean(emitted_power(*light), power * M_PI * 16.0, 0.02, 1e-3);
  EXPECT_NEAR(light->power().average(), power * M_PI * 16.0, 0.03 * power * M_PI * 16.0);
  expect_mean(connected_irradiance(*light, {0, 0, 0}, normal), irradiance, 0.02, 1e-3);
  expect_mean(emitted_irradiance(*light, small_patch({0.2F, 0, 0}, normal, 1.5F), 2000000),
              irradiance, 0.05, 1e-3);
}

TEST(EnvironmentMap, TinySunIsIntegratedWithLittleNoise) {
  std::vector<float> sky = one_bright(256, 128, 40, 30, 1e6F);
  for (float& v : sky) v += 0.1F;
  const ImageFile file(256, 128, sky);
  const auto light = light_of(environment_node({1, 1, 1}, file.path()), Mat4());
  // A bilinear hat has the volume of one texel.
  const double theta = M_PI * 30.5 / 128;
  const double expected = 0.4 * M_PI + 1e6 * 2 * M_PI * M_PI / (256 * 128) * std::sin(theta);
  Rng rng(5);
  Mean mean;
  for (int i = 0; i < 20000; ++i) {
    const auto sample = light->sample_connection({0, 0, 0}, connection_uniforms(rng));
    mean.add(sample ? sample->weight.average() : 0.0);
  }
  expect_mean(mean, expected, 0.03, 1e-3);
}

TEST(EnvironmentMap, EvenMapIsSampledEvenly) {
  const ImageFile file(32, 16, std::vector<float>(3 * 32 * 16, 2.F));
  const auto light = light_of(environment_node({1, 1, 1}, file.path()), Mat4());
  Rng rng(6);
  Mean mean;
  constexpr int kSamples = 10000;
  for (int i = 0; i < kSamples; ++i) {
    mean.add(light->sample_connection({0, 0, 0}, connection_uniforms(rng))->weight.average());
  }
  EXPECT_NEAR(mean.value(), 8.0 * M_PI, 0.1);
  EXPECT_LT(mean.error() * std::sqrt(kSamples), 0.1 * mean.value());
}

TEST(EnvironmentMap, ScaledAndMirroredSpacesIntegrateTheSame) {
  const ImageFile file(12, 6, random_pixels(72, 2));
  const Mat4 mirrored = scaling(-2, 2, 2) * rotation({1, 2, 3}, 0.9);
  const Mat4 stretched = scaling(1, 2, 0.5) * rotation({1, 2, 3}, 0.9);
  for (const Mat4& to_world : {mirrored, stretched}) {
    const auto light = light_of(environment_node({1, 1, 1}, file.path()), to_world);
    check_emission(*light);
    check_connection(*light, {{0, 0, 0}});
    double integral = 0.0;
    const Chart<Vec3> sphere = cone_chart({0, 1, 0});
    constexpr int kSide = 512;
    for (int i = 0; i < kSide * kSide; ++i) {
      const int column = i % kSide;
      const int row = i / kSide;
      const Vec2 s((static_cast<float>(column) + 0.5F) / kSide,
                   (static_cast<float>(row) + 0.5F) / kSide);
      const Vec3 w = sphere.point(s);
      integral += light->emitted(light->at_direction(w), -w).average() * sphere.measure(s) /
                  (kSide * kSide);
    }
    expect_mean(emitted_power(*light), integral * M_PI * 16.0, 0.02, 2e-3);
  }
}

TEST(EnvironmentMap, BlackMapEmitsNothing) {
  const ImageFile file(4, 2, std::vector<float>(24, 0.F));
  const auto light = light_of(environment_node({1, 1, 1}, file.path()), Mat4());
  EXPECT_TRUE(light->power().is_black());
  EXPECT_FALSE(light->sample_emission({0.5F, {0.5F, 0.5F}, {0.5F, 0.5F}}));
  EXPECT_FALSE(light->sample_connection({0, 0, 0}, {0.5F, {0.5F, 0.5F}}));
}

TEST(GoniometricLight, WeightsDensitiesAndFlux) {
  const ImageFile file(12, 6, random_pixels(72, 3));
  const Mat4 to_world = rotation({1, 2, 3}, 0.9) * translation({0.2F, 0.1F, 1.F});
  const auto light = light_of(goniometric_node({1, 2, 3}, file.path()), to_world);
  // The direction alone does not say on which side of a cell border it was sampled.
  check_emission(*light, 20000, 20);
  check_connection(*light, {{0, 0, 0}, {1, 0, 2}, {-1, 1, 1}});
  // pbrt-v3 swaps y and z before it looks into the map.
  const Mat4 swap(1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
  check_departures(*light, lat_long_chart(swap * rotation({1, 2, 3}, 0.9)), 24, 12, 12);
  expect_mean(emitted_power(*light), light->power().average(), 0.02, 0.02);
  expect_patch_agrees(*light, Quad({-0.6F, -0.5F, 0}, {1.2F, 0, 0.1F}, {0, 1, 0}));
}

TEST(GoniometricLight, YIsThePole) {
  std::vector<float> rgb(3 * 8 * 4, 0.F);
  for (int i = 0; i < 3 * 8; ++i) rgb[static_cast<std::size_t>(i)] = 1.F;  // top row
  const ImageFile file(8, 4, rgb);
  const auto light = light_of(goniometric_node({1, 1, 1}, file.path()), Mat4());
  const EndpointPoint point = EndpointPoint::at(Vec3(0.F));
  EXPECT_NEAR(light->emitted(point, {0, 1, 0})[0], 1.F, 1e-5F);
  EXPECT_TRUE(light->emitted(point, {0, 0, 1}).is_black());
  EXPECT_TRUE(light->emitted(point, {0, -1, 0}).is_black());
}

TEST(GoniometricLight, MayTakeTheMeanOfColours) {
  std::vector<float> rgb;
  for (int i = 0; i < 8 * 4; ++i) rgb.insert(rgb.end(), {0.3F, 0.6F, 1.5F});
  const ImageFile file(8, 4, rgb);
  desc::Node node = goniometric_node({1, 2, 3}, file.path());
  node.set("gray", true);
  const Spectrum seen = light_of(node, Mat4())->emitted(EndpointPoint::at(Vec3(0.F)), {0, 0, 1});
  EXPECT_NEAR(seen[0], 0.8F, 1e-5F);
  EXPECT_NEAR(seen[1], 1.6F, 1e-5F);
  EXPECT_NEAR(seen[2], 2.4F, 1e-5F);
}

TEST(GoniometricLight, WithoutImageIsAPointLight) {
  const auto light = light_of(goniometric_node({2, 2, 2}), Mat4());
  EXPECT_NEAR(light->power().average(), 8.0 * M_PI, 1e-4);
}

TEST(ProjectionLight, WeightsDensitiesAndFlux) {
  const ImageFile file(12, 6, random_pixels(72, 4));
  const Mat4 place = aimed({0.2F, 0.1F, 2.F}, {0, 0, 0});
  for (const Mat4& shape : {Mat4(), scaling(-1, 1, 1), scaling(1, 2, 0.5), scaling(2, 2, 2)}) {
    desc::Node node = projection_node({1, 2, 3}, 60, file.path());
    if (shape == scaling(2, 2, 2)) node.set("image_is", std::string("irradiance"));
    const auto light = light_of(std::move(node), shape * place);
    check_emission(*light, 20000, 20);
    check_connection(*light, {{0, 0, 0}, {0.4F, 0.2F, 0.5F}, {-0.3F, 0, 0}});
    // Flux by quadrature of the intensity over all directions.
    double flux = 0.0;
    const Chart<Vec3> sphere = cone_chart({0, 0, -1});
    constexpr int kSide = 1024;
    for (int i = 0; i < kSide * kSide; ++i) {
      const int column = i % kSide;
      const int row = i / kSide;
      const Vec2 s((static_cast<float>(column) + 0.5F) / kSide,
                   (static_cast<float>(row) + 0.5F) / kSide);
      flux += light->emitted(EndpointPoint::at({0.2F, 0.1F, 2.F}), sphere.point(s)).average() *
              sphere.measure(s) / (kSide * kSide);
    }
    expect_mean(emitted_power(*light), flux, 0.02, 3e-3);
    expect_patch_agrees(*light, Quad({-0.6F, -0.5F, 0}, {1.2F, 0, 0.1F}, {0, 1, 0}));
  }
  const auto light = light_of(projection_node({1, 2, 3}, 60, file.path()), Mat4());
  expect_mean(emitted_power(*light), light->power().average(), 0.02, 0.01);
  // A chart that fits the cells: the window at z = 1 is 4 × 2 half sides of tan 30°.
  const double tangent = std::tan(M_PI / 6);
  const Chart<Vec3> window{
      [=](const Vec2& s) {
        return normalize(Vec3(static_cast<float>((4 * s.x - 2) * tangent),
                              static_cast<float>((2 * s.y - 1) * tangent), 1.F));
      },
      [=](const Vec2& s) {
        const double x = (4 * s.x - 2) * tangent;
        const double y = (2 * s.y - 1) * tangent;
        return 8 * tangent * tangent / std::pow(1 + x * x + y * y, 1.5);
      },
      [=](const Vec3& w) {
        return Vec2(static_cast<float>((w.x / w.z / tangent + 2) / 4),
                    static_cast<float>((w.y / w.z / tangent + 1) / 2));
      }};
  check_departures(*light, window, 24, 12, 12);
}

TEST(ProjectionLight, MayHaveItsIrradianceOnAPlane) {
  desc::Node node = projection_node({1, 2, 3}, 100);
  node.set("image_is", std::string("irradiance"));
  const auto light = light_of(std::move(node), scaling(1, 3, 2));
  for (const Vec3& at : {Vec3(0, 0, 1), Vec3(0.5F, 0.2F, 1), Vec3(-0.4F, 0.7F, 1)}) {
    const Vec3 w = normalize(at);
    // Intensity · cos³ θ, of a plane at the distance 1.
    EXPECT_NEAR(light->emitted(EndpointPoint::at(Vec3(0.F)), w)[1] * w.z * w.z * w.z, 2.F, 1e-4F);
  }
  node = projection_node({1, 2, 3}, 60);
  node.set("image_is", std::string("irradiance"));
  const auto plain = light_of(std::move(node), Mat4());
  expect_mean(emitted_power(*plain), plain->power().average(), 0.02, 0.01);
}

TEST(ProjectionLight, FieldOfViewIsThatOfOneSideOfTheImage) {
  const ImageFile file(12, 6, random_pixels(72, 4));
  const float half = std::tan(25.F * kPi / 180.F);
  for (const auto& [axis, across] :
       std::map<std::string, float>{{"shorter", 2.F},
                                    {"longer", 1.F},
                                    {"x", 1.F},
                                    {"y", 2.F},
                                    {"diagonal", 2.F / std::sqrt(5.F)}}) {
    desc::Node node = projection_node({1, 1, 1}, 50, file.path());
    node.set("fov_axis", axis);
    const auto light = light_of(std::move(node), Mat4());
    const auto lit = [&](float x, float y) {
      const Vec3 w = normalize(Vec3(x * across * half, y * 0.5F * across * half, 1.F));
      return !light->emitted(EndpointPoint::at(Vec3(0.F)), w).is_black();
    };
    EXPECT_TRUE(lit(0.99F, 0.F) && lit(0.F, -0.99F)) << axis;
    EXPECT_FALSE(lit(1.01F, 0.F) || lit(0.F, -1.01F)) << axis;
  }
}

TEST(ProjectionLight, RowZeroIsAtMinusYAndColumnZeroAtMinusX) {
  const ImageFile file(4, 4, one_bright(4, 4, 3, 0, 8.F));
  const auto light = light_of(projection_node({1, 1, 1}, 90, file.path()), Mat4());
  const EndpointPoint point = EndpointPoint::at(Vec3(0.F));
  EXPECT_NEAR(light->emitted(point, normalize(Vec3(0.75F, -0.75F, 1)))[0], 8.F, 1e-4F);
  EXPECT_TRUE(light->emitted(point, normalize(Vec3(-0.75F, 0.75F, 1))).is_black());
  EXPECT_TRUE(light->emitted(point, normalize(Vec3(1.01F, -0.75F, 1))).is_black());
  EXPECT_TRUE(light->emitted(point, normalize(Vec3(0.75F, -0.75F, -1))).is_black());
}

}  // namespace
}  // namespace ajar
