#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/methods.h"
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
struct AnalyticEstimate {
  double mean;
  double standard_error;
};
AnalyticEstimate estimate(const test::Render& picture) {
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
  const AnalyticEstimate e = estimate(picture);
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
  const AnalyticEstimate e = estimate(render(*scene, samples(8)));
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

TEST(Media, SmokeThatAbsorbsNothingIsInvisibleInAFurnace) {
  const auto scene = scene_from(pbrt_scene(
      "MakeNamedMedium \"smoke\" \"string type\" \"heterogeneous\" \"rgb sigma_a\" [0 0 0] "
      "\"rgb sigma_s\" [1 0.5 0.2] \"float g\" [0.5] \"integer nx\" 2 \"integer ny\" 2 "
      "\"integer nz\" 2 \"float density\" [0 3 1 0 2 0 5 1] \"point p0\" [-1 -1 -1]\n" +
          std::string(kCamera),
      8, 8,
      "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMediumInterface \"smoke\" "
      "\"\"\nMaterial \"\"\nShape \"sphere\" \"float radius\" [2]"));
  test::RenderOptions options = samples(2048);
  options.max_depth = 1000;
  expect_mean(render(*scene, options), 1.0, 0.02);
}

TEST(Media, SmokeOfManyColorsThatAbsorbsNothingIsInvisibleInAFurnace) {
  // Lanes differ in every cell, and some have nothing in the way of others that have much.
  const auto scene = scene_from(pbrt_scene(
      "MakeNamedMedium \"smoke\" \"string type\" \"rgbgrid\" \"float g\" [0.5] \"integer nx\" 2 "
      "\"integer ny\" 2 \"integer nz\" 2 \"rgb sigma_a\" [0 0 0  0 0 0  0 0 0  0 0 0  0 0 0  0 0 0 "
      " 0 0 0  0 0 0] \"rgb sigma_s\" [2 0 0  0 1 0  0 0 1  2 1 0  0 0 2  1 0 1  1 2 0.5  0 0 0] "
      "\"point p0\" [-1 -1 -1]\n" +
          std::string(kCamera),
      8, 8,
      "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMediumInterface \"smoke\" "
      "\"\"\nMaterial \"\"\nShape \"sphere\" \"float radius\" [2]"));
  test::RenderOptions options = samples(2048);
  options.max_depth = 1000;
  expect_mean(render(*scene, options), 1.0, 0.02);
}

TEST(Media, SmokeOfTheSameDensityEverywhereIsFog) {
  const auto picture = [](const std::string& type, const std::string& integrator) {
    const auto scene = scene_from(pbrt_scene(
        "MakeNamedMedium \"m\" \"rgb sigma_a\" [0.2 0.1 0.3] \"rgb sigma_s\" [1 0.5 0.2] " + type +
            "\n" + std::string(kCamera),
        8, 8,
        "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMediumInterface \"m\" \"\"\nMaterial "
        "\"\"\nShape \"sphere\" \"float radius\" [1]"));
    test::RenderOptions options = samples(512);
    options.integrator = integrator;
    return render(*scene, options).mean();
  };
  // Values at points outside of the box are 0: it is much larger than the ball.
  const std::string smoke =
      "\"string type\" \"heterogeneous\" \"integer nx\" 3 \"integer ny\" 3 \"integer nz\" 3 "
      "\"point p0\" [-9 -9 -9] \"point p1\" [9 9 9] \"float density\" "
      "[2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2 2]";
  const std::string fog = "\"string type\" \"homogeneous\" \"float scale\" 2";
  const double expected = picture(fog, "pt");
  for (const char* integrator : {"pt", "bdpt"}) {
    EXPECT_NEAR(picture(smoke, integrator), expected, 0.01 * expected) << integrator;
  }
}

/// Techniques that start at the light against closed forms, whole pictures at a time.
class FromTheLight : public ::testing::TestWithParam<std::string> {
 protected:
  test::RenderOptions options(int count) const {
    test::RenderOptions result = samples(count);
    result.integrator = GetParam();
    if (!test::has_chains(GetParam())) {
      result.parameters = {{"light-paths-per-pixel", "1"}};
    }
    return result;
  }
  /// Chains know the mean from their bootstrap, less certain; their samples are few.
  void expect_mean_of(int count, const Scene& scene, double expected) const {
    const bool has_chains = test::has_chains(GetParam());
    const test::Render picture = render(scene, options(has_chains ? count / 4 : count));
    expect_mean(picture, expected, has_chains ? 0.12 : 0.02);
  }
};

/// A diffuse disk of radius 0.9 and reflectance 0.5, seen whole through a window of 2 × 2.
std::string disk_under(const std::string& light) {
  return pbrt_scene("LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"orthographic\"", 16, 16,
                    light +
                        "\nMaterial \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\nShape \"disk\" "
                        "\"float radius\" [0.9]");
}

TEST_P(FromTheLight, PointLightFluxOntoADisk) {
  const auto scene =
      scene_from(disk_under("LightSource \"point\" \"point from\" [0 0 -1.5] \"rgb I\" [7 7 7]"));
  const double flux = 7.0 * 2.0 * M_PI * (1.0 - 1.5 / std::hypot(1.5, 0.9));
  expect_mean_of(256, *scene, 0.5 / M_PI * flux / 4.0);
}

TEST_P(FromTheLight, DistantLightOntoADisk) {
  const auto scene = scene_from(
      disk_under("LightSource \"distant\" \"point from\" [3 0 -4] \"point to\" [0 0 0] \"rgb L\" "
                 "[2 2 2]"));
  const double irradiance = 2.0 * 0.8;
  expect_mean_of(256, *scene, 0.5 / M_PI * irradiance * M_PI * 0.81 / 4.0);
}

TEST_P(FromTheLight, EnvironmentOntoADiskAndBehindIt) {
  const auto scene = scene_from(disk_under("LightSource \"infinite\" \"rgb L\" [3 3 3]"));
  const double covered = M_PI * 0.81 / 4.0;
  expect_mean_of(256, *scene, 3.0 * (0.5 * covered + (1.0 - covered)));
}

TEST_P(FromTheLight, ClosedRoomSumsAllBounces) {
  const auto scene = scene_from(
      pbrt_scene("LookAt 0 0 0  0 0 1  0 1 0\nCamera \"perspective\" \"float fov\" [90]", 12, 8,
                 "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\nReverseOrientation\nAreaLightSource "
                 "\"diffuse\" \"rgb L\" [1 1 1]\n"
                 "Shape \"sphere\" \"float radius\" [2]"));
  expect_mean_of(512, *scene, 2.0);
}

TEST_P(FromTheLight, ThroughAMirrorChain) {
  // A spot shines on a mirror that throws the light down onto a disk: all of it, times 0.8. The
  // camera stands between mirror and disk.
  const auto scene = scene_from(pbrt_scene(
      "LookAt 0 0 -2  0 0 0  0 1 0\nCamera \"orthographic\"", 16, 16,
      "LightSource \"spot\" \"point from\" [5 0 -3] \"point to\" [0 0 -3] \"float coneangle\" [3] "
      "\"float conedeltaangle\" [0] \"rgb I\" [50 50 50]\n"
      "AttributeBegin Material \"mirror\" \"rgb Kr\" [0.8 0.8 0.8] Translate 0 0 -3 Rotate 45 0 1 "
      "0 "
      "Shape \"disk\" \"float radius\" [0.7] AttributeEnd\n"
      "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\nShape \"disk\" \"float radius\" [0.9]"));
  const double flux = 50.0 * 2.0 * M_PI * (1.0 - std::cos(3.0 * M_PI / 180.0));
  expect_mean_of(256, *scene, 0.8 * flux * 0.5 / M_PI / 4.0);
}

TEST_P(FromTheLight, PhotonsThatHitTheLensPassThroughIt) {
  // A lamp behind a lens of radius 1 lights the visible surface, right through the lens: nothing
  // blocks that light, and no technique may count it as arriving at the film.
  const auto scene = scene_from(pbrt_scene(
      "LookAt 0 0 -4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [20] \"float lensradius\" "
      "[1] \"float focaldistance\" [4]",
      16, 16,
      "LightSource \"spot\" \"point from\" [0 0 -8] \"point to\" [0 0 0] \"float coneangle\" [30] "
      "\"float conedeltaangle\" [0] \"rgb I\" [100 100 100]\n"
      "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\nShape \"disk\" \"float radius\" [4]"));
  test::RenderOptions path_tracing = samples(64);
  const double expected = estimate(render(*scene, path_tracing)).mean;
  // In focus, so the middle of the disk alone: I / d² · ρ / π, the cosines nearly 1.
  EXPECT_NEAR(expected, 100.0 / 64.0 * 0.5 / M_PI, 0.02 * expected);
  expect_mean_of(512, *scene, expected);
}

INSTANTIATE_TEST_SUITE_P(Methods, FromTheLight,
                         ::testing::ValuesIn(test::methods_but(
                             {{"pt", "it starts at the camera; the tests above are its own"}})),
                         [](const auto& test) { return test::name_for_tests(test.param); });

}  // namespace
}  // namespace ajar
