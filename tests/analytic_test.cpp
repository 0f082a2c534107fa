#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/render.h"

/// Scenes whose pictures are known in closed form.
namespace ajar {
namespace {

using test::pbrt_scene;
using test::render;
using test::scene_from;

const char* const kCamera =
    "LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [20]";

/// Mean over pixels and channels, and its standard error from replicates.
struct Estimate {
  double mean;
  double standard_error;
};
Estimate estimate(const test::Render& picture) {
  std::vector<double> means;
  for (int r = 0; r < picture.film->replicates(); ++r) {
    const std::vector<float> pixels = picture.replicate(r);
    means.push_back(std::accumulate(pixels.begin(), pixels.end(), 0.0) /
                    static_cast<double>(pixels.size()));
  }
  const double count = static_cast<double>(means.size());
  const double mean = std::accumulate(means.begin(), means.end(), 0.0) / count;
  double squares = 0.0;
  for (const double m : means) squares += (m - mean) * (m - mean);
  return {mean, std::sqrt(squares / (count - 1.0) / count)};
}

/// Within 5 standard errors (plus float rounding), and precise enough to notice a deviation of
/// `power`.
void expect_mean(const test::Render& picture, double expected, double power) {
  const Estimate e = estimate(picture);
  EXPECT_NEAR(e.mean, expected, 5.0 * e.standard_error + 2e-5 * expected);
  EXPECT_LT(5.0 * e.standard_error, power * expected) << "too noisy to notice what it should";
}

test::RenderOptions samples(int count) {
  test::RenderOptions options;
  options.samples = count;
  return options;
}

class Furnace : public ::testing::TestWithParam<const char*> {};

TEST_P(Furnace, ObjectThatAbsorbsNothingIsInvisible) {
  const auto scene =
      scene_from(pbrt_scene(kCamera, 16, 16,
                            std::string("LightSource \"infinite\" \"rgb L\" [1 1 1]\n") +
                                GetParam() + " Shape \"sphere\" \"float radius\" [1]"));
  test::RenderOptions options = samples(256);
  options.max_depth = 1000;
  const auto picture = render(*scene, options);
  expect_mean(picture, 1.0, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Materials, Furnace,
                         ::testing::Values("Material \"matte\" \"rgb Kd\" [1 1 1]",
                                           "Material \"mirror\" \"rgb Kr\" [1 1 1]",
                                           "Material \"glass\"", "Material \"none\"",
                                           "Material \"glass\" \"float index\" [1.33]"));

TEST(Furnace, ClosedRoomSumsAllBounces) {
  // Inside a sphere that emits L and reflects ρ everything has radiance L / (1 − ρ).
  const auto scene = scene_from(
      pbrt_scene("LookAt 0 0 0  0 0 1  0 1 0\nCamera \"perspective\" \"float fov\" [90]", 12, 8,
                 "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\nReverseOrientation\nAreaLightSource "
                 "\"diffuse\" \"rgb L\" [1 1 1]\n"
                 "Shape \"sphere\" \"float radius\" [2]"));
  const auto picture = render(*scene, samples(512));
  expect_mean(picture, 2.0, 0.01);
}

TEST(Furnace, DepthRangeCutsTheSeriesWhereAsked) {
  const auto scene = scene_from(
      pbrt_scene("LookAt 0 0 0  0 0 1  0 1 0\nCamera \"perspective\" \"float fov\" [90]", 12, 8,
                 "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\nReverseOrientation\nAreaLightSource "
                 "\"diffuse\" \"rgb L\" [1 1 1]\n"
                 "Shape \"sphere\" \"float radius\" [2]"));
  double expected = 0.0;
  for (int depth = 1; depth <= 4; ++depth) {
    test::RenderOptions options = samples(256);
    options.max_depth = depth;
    expected += std::pow(0.5, depth - 1);
    expect_mean(render(*scene, options), expected, 0.01);
    options.min_depth = depth;
    expect_mean(render(*scene, options), std::pow(0.5, depth - 1), 0.01);
  }
}

TEST(DirectLight, PointLightFollowsTheInverseSquareAndTheCosine) {
  // Plane z = 0 seen by one pixel around the origin; light 2 in front of it, 1 to the side.
  const auto scene = scene_from(
      pbrt_scene("LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [0.05]", 4, 4,
                 "LightSource \"point\" \"point from\" [1 0 -2] \"rgb I\" [10 10 10]\nMaterial "
                 "\"matte\" \"rgb Kd\" [0.5 0.5 0.5]\n"
                 "Shape \"trianglemesh\" \"point P\" [-9 -9 0  9 -9 0  9 9 0  -9 9 0] \"integer "
                 "indices\" [0 1 2 0 2 3]"));
  const double expected = 0.5 / M_PI * 10.0 * (2.0 / std::sqrt(5.0)) / 5.0;
  const Estimate e = estimate(render(*scene, samples(8)));
  EXPECT_NEAR(e.mean, expected, 1e-4 * expected);
}

TEST(DirectLight, DistantLightGivesItsIrradianceTimesCosine) {
  const auto scene = scene_from(
      pbrt_scene("LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [1]", 4, 4,
                 "LightSource \"distant\" \"point from\" [3 0 -4] \"point to\" [0 0 0] \"rgb L\" "
                 "[2 2 2]\nMaterial \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\n"
                 "Shape \"trianglemesh\" \"point P\" [-9 -9 0  9 -9 0  9 9 0  -9 9 0] \"integer "
                 "indices\" [0 1 2 0 2 3]"));
  EXPECT_NEAR(render(*scene, samples(8)).mean(), 0.5 / M_PI * 2.0 * 0.8, 1e-4);
}

TEST(DirectLight, SphereLightEqualsTheSolidAngleFormula) {
  // A sphere of radius r at height d over a plane gives E = π L (r/d)² at the foot.
  const auto scene = scene_from(
      pbrt_scene("LookAt 3 0 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [0.05]", 4, 4,
                 "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [5 5 5] Translate 0 0 -2 "
                 "Shape \"sphere\" \"float radius\" [0.5] AttributeEnd\n"
                 "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\n"
                 "Shape \"trianglemesh\" \"point P\" [-9 -9 0  9 -9 0  9 9 0  -9 9 0] \"integer "
                 "indices\" [0 1 2 0 2 3]"));
  test::RenderOptions options = samples(256);
  options.max_depth = 2;
  expect_mean(render(*scene, options), 0.5 * 5.0 * 0.0625, 0.01);
}

TEST(DirectLight, EnvironmentOnAPlaneGivesAlbedoTimesRadiance) {
  const auto scene = scene_from(pbrt_scene(
      "LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [10]", 8, 4,
      "LightSource \"infinite\" \"rgb L\" [3 3 3]\nMaterial \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\n"
      "Shape \"disk\" \"float radius\" [20]"));
  expect_mean(render(*scene, samples(128)), 1.5, 0.01);
}

TEST(Mirrors, ChainMultipliesReflectances) {
  // Camera → mirror at 45° → mirror at 45° → emitter: 0.8 · 0.5 · L.
  const auto scene = scene_from(
      pbrt_scene("LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [2]", 4, 4,
                 "AttributeBegin Material \"mirror\" \"rgb Kr\" [0.8 0.8 0.8] Rotate 45 0 1 0 "
                 "Shape \"disk\" \"float radius\" [1] AttributeEnd\n"
                 "AttributeBegin Material \"mirror\" \"rgb Kr\" [0.5 0.5 0.5] Translate 4 0 0 "
                 "Rotate 45 0 1 0 Shape \"disk\" \"float radius\" [1] AttributeEnd\n"
                 "AttributeBegin Material \"mirror\" \"rgb Kr\" [0.5 0.5 0.5] Translate -4 0 0 "
                 "Rotate 45 0 1 0 Shape \"disk\" \"float radius\" [1] AttributeEnd\n"
                 "LightSource \"infinite\" \"rgb L\" [7 7 7]"));
  EXPECT_NEAR(render(*scene, samples(4)).mean(), 0.8 * 0.5 * 7.0, 1e-4);
}

TEST(Media, AbsorptionFollowsBeersLaw) {
  const auto scene = scene_from(
      pbrt_scene("MakeNamedMedium \"ink\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [0.5 0.5 "
                 "0.5] \"rgb sigma_s\" [0 0 0]\n"
                 "LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [0.5]",
                 4, 4,
                 "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMediumInterface \"ink\" "
                 "\"\"\nMaterial \"\"\nShape \"sphere\" \"float radius\" [1.5]"));
  EXPECT_NEAR(render(*scene, samples(4)).mean(), std::exp(-1.5), 1e-4);
}

TEST(Media, FogThatAbsorbsNothingIsInvisibleInAFurnace) {
  const auto scene =
      scene_from(pbrt_scene("MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb "
                            "sigma_a\" [0 0 0] \"rgb sigma_s\" [1 0.5 0.2] \"float g\" [0.5]\n" +
                                std::string(kCamera),
                            8, 8,
                            "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMediumInterface \"fog\" "
                            "\"\"\nMaterial \"\"\nShape \"sphere\" \"float radius\" [1]"));
  test::RenderOptions options = samples(512);
  options.max_depth = 1000;
  expect_mean(render(*scene, options), 1.0, 0.02);
}

TEST(Layers, DirectAndIndirectAreTheWhole) {
  const auto scene = scene_from(
      pbrt_scene("LookAt 0 0 0  0 0 1  0 1 0\nCamera \"perspective\" \"float fov\" [90]", 12, 8,
                 "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\nReverseOrientation\nAreaLightSource "
                 "\"diffuse\" \"rgb L\" [1 1 1]\n"
                 "Shape \"sphere\" \"float radius\" [2]"));
  test::RenderOptions options = samples(64);
  const auto picture = render(*scene, options);
  const auto direct = picture.film->develop(picture.film->layer("direct"), picture.scale);
  // 1 (seen directly) + 0.5 (one bounce).
  EXPECT_NEAR(
      std::accumulate(direct.begin(), direct.end(), 0.0) / static_cast<double>(direct.size()), 1.5,
      0.03);
}

}  // namespace
}  // namespace ajar
