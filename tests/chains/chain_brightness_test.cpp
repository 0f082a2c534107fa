#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/random.h"
#include "imageio/pfm.h"
#include "mcmc/moments.h"
#include "support/methods.h"
#include "support/render.h"
#include "support/same_picture.h"
#include "support/small_scenes.h"

/// Invariants of chains: brightness, whatever the importance map, and its scatter.
namespace ajar {
namespace {

using test::expect_same;
using test::replicates_of;
using test::small_scene;

/// A map that no sensible person would use: every pixel between 1/50 and 50, at random.
class NoiseMap {
 public:
  NoiseMap(int width, int height)
      : path_(std::filesystem::temp_directory_path() /
              ("ajar-noise-" + std::to_string(getpid()) + ".pfm")) {
    std::vector<float> rgb;
    for (int i = 0; i < width * height; ++i) {
      const auto bits = static_cast<std::uint32_t>(hash_numbers(17, i) >> 32U);
      const float weight = std::pow(50.F, 2.F * to_unit_float(bits) - 1.F);
      rgb.insert(rgb.end(), 3, weight);
    }
    const std::vector<std::byte> bytes = encode_pfm(width, height, rgb);
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  ~NoiseMap() { std::filesystem::remove(path_); }
  NoiseMap(const NoiseMap&) = delete;
  NoiseMap& operator=(const NoiseMap&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

class Importance : public ::testing::TestWithParam<const char*> {};

TEST_P(Importance, LeavesTheExpectationAsItIs) {
  const test::SmallScene small = small_scene(GetParam());
  const auto scene = test::scene_from(small.text);
  const Vec2i resolution = scene->camera().resolution();
  test::RenderOptions options;
  options.replicates = 16;
  options.max_depth = 6;
  options.crop = small.crop;
  options.samples = 128;
  options.integrator = "bdpt";
  const Replicates truth = replicates_of(test::render(*scene, options), "indirect");
  // Noise of the full picture, or of the crop alone.
  const Vec2i size = small.crop ? small.crop->max - small.crop->min + Vec2i(1, 1) : resolution;
  const NoiseMap noise(size.x, size.y);
  options.seed = 2;
  options.samples = 224;
  for (const char* integrator : {"mmlt+", "pssmlt+"}) {
    options.integrator = integrator;
    for (const std::string& map : {std::string("relative"), noise.path()}) {
      options.parameters = {{"importance", map}, {"bootstrap", "100000"}};
      const test::Render render = test::render(*scene, options);
      expect_same(replicates_of(render, "indirect"), truth, *render.film, 0.4,
                  std::string(integrator) + ", importance " + map);
    }
  }
  // Chains of explicit paths weight their part by the map, too.
  options.integrator = "selective";
  for (const char* chain : {"mlt", "erpt"}) {
    options.parameters = {{"chain", chain}, {"split", "0.5"}, {"importance", noise.path()}};
    const test::Render render = test::render(*scene, options);
    expect_same(replicates_of(render, "indirect"), truth, *render.film, 0.4,
                std::string("selective, chain ") + chain);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Importance,
                         ::testing::Values("Room", "GlassAndMetal", "CroppedMitchell"));

TEST(Importance, MapOfTheFullPictureServesACropOfIt) {
  const test::SmallScene small = small_scene("CroppedMitchell");
  const auto scene = test::scene_from(small.text);
  test::RenderOptions options;
  options.replicates = 16;
  options.max_depth = 5;
  options.crop = small.crop;
  options.samples = 512;
  options.integrator = "mmlt+";
  options.parameters = {{"bootstrap", "120000"}};
  const Replicates truth = replicates_of(test::render(*scene, options), "indirect");
  const NoiseMap noise(64, 40);
  options.parameters["importance"] = noise.path();
  options.seed = 2;
  const test::Render render = test::render(*scene, options);
  expect_same(replicates_of(render, "indirect"), truth, *render.film, 0.4, "full map");
}

/// Mean of a picture over pixels and channels, by seeds 1, 2, …
struct Scatter {
  Moments means;           ///< one per seed
  Moments error_variance;  ///< squared standard errors of the same, from replicates
};
Scatter scatter(const Scene& scene, test::RenderOptions options, int seeds) {
  Scatter result;
  for (int seed = 1; seed <= seeds; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    const Estimate mean = image_mean(replicates_of(test::render(scene, options), "indirect"));
    result.means.add(mean.value);
    result.error_variance.add(mean.standard_error * mean.standard_error);
  }
  return result;
}

class OverSeeds : public ::testing::TestWithParam<std::string> {};

TEST_P(OverSeeds, BrightnessScattersWithinErrorBars) {
  constexpr int kSeeds = 100;
  // As published, mmlt knows b from the bootstrap alone, to which caustics are rare.
  const bool is_published_mmlt = GetParam() == "mmlt";
  const auto scene =
      test::scene_from(small_scene(is_published_mmlt ? "Room" : "NestedDielectrics").text);
  test::RenderOptions options;
  options.replicates = 8;
  options.max_depth = 6;
  // Chains of explicit paths, and those without ordinary Monte Carlo, scatter twice as much.
  const bool scatters = is_published_mmlt || GetParam() == "mlt" || GetParam() == "erpt";
  options.samples = scatters ? 40 : 16;
  options.integrator = GetParam();
  options.parameters = {{"bootstrap", scatters ? "8000" : "4000"}};
  const Scatter chains = scatter(*scene, options, kSeeds);

  // The variance of means over that of error bars follows F(99, 700). ½ ln F is nearly normal with
  // variance ½ (1/99 + 1/700) (Fisher's z), so within 5 of its standard deviations the ratio is
  // between 0.47 and 2.1: error bars wrong by half are noticed.
  const double n = kSeeds;
  const double between = chains.means.standard_error() * chains.means.standard_error() * n;
  const double ratio = between / chains.error_variance.mean();
  const double deviation = std::sqrt(0.5 * (1.0 / (n - 1.0) + 1.0 / (n * 7.0)));
  EXPECT_LT(std::abs(0.5 * std::log(ratio)), 5.0 * deviation) << "variance ratio " << ratio;

  options.integrator = "bdpt";
  options.parameters = {};
  options.samples = 1536;
  options.seed = 1;
  const Estimate truth = image_mean(replicates_of(test::render(*scene, options), "indirect"));
  const double error = std::hypot(truth.standard_error, chains.means.standard_error());
  EXPECT_NEAR(chains.means.mean(), truth.value, 5.0 * error);
  EXPECT_LT(5.0 * error, 0.06 * truth.value) << "too noisy to notice what it should";
}

INSTANTIATE_TEST_SUITE_P(
    Chains, OverSeeds,
    ::testing::ValuesIn(test::methods_but(test::those_without_chains("it has no b"))),
    [](const auto& test) { return test::name_for_tests(test.param); });

/// A floor and a wall lit by a small ball. Camera paths alone hardly ever run into it.
std::unique_ptr<Scene> rarely_lit(double radius) {
  return test::scene_from(test::pbrt_scene(
      "LookAt 0 1 -3  0 0.5 0  0 1 0\nCamera \"perspective\" \"float fov\" [50]", 12, 8,
      "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [100 100 100] Translate 0 0.7 0.2\n"
      "Shape \"sphere\" \"float radius\" [" +
          std::to_string(radius) +
          "] AttributeEnd\n"
          "Material \"matte\" \"rgb Kd\" [0.8 0.8 0.8]\n"
          "Shape \"trianglemesh\" \"point P\" [-2 0 -2  2 0 -2  2 0 1  -2 0 1] \"integer "
          "indices\" [0 2 1 0 3 2]\n"
          "Shape \"trianglemesh\" \"point P\" [-2 0 1  2 0 1  2 3 1  -2 3 1] \"integer "
          "indices\" [0 2 1 0 3 2]\n"));
}

test::RenderOptions rare_options() {
  test::RenderOptions options;
  options.replicates = 2;
  options.min_depth = 3;
  options.max_depth = 3;
  return options;
}

Estimate rare_truth(const Scene& scene) {
  test::RenderOptions options = rare_options();
  options.integrator = "pt";
  options.samples = 8192;
  return image_mean(replicates_of(test::render(scene, options)));
}

struct RareCase {
  const char* integrator;
  double radius;
  int samples;  ///< mutations per pixel; 16 and 32 make four passes, others one
  int seeds;

  friend void PrintTo(const RareCase& c, std::ostream* out) {
    *out << c.integrator << ", radius " << c.radius << ", " << c.samples << " samples";
  }
};
class RareLight : public ::testing::TestWithParam<RareCase> {};

// With so small a bootstrap a population often finds no light, and one that does takes it for much
// more than it is. Both are right on average only together.
TEST_P(RareLight, IsRightOnAverageThoughTheBootstrapMostlyMissesIt) {
  const auto scene = rarely_lit(GetParam().radius);
  test::RenderOptions options = rare_options();
  const Estimate truth = rare_truth(*scene);
  options.integrator = GetParam().integrator;
  options.samples = GetParam().samples;
  options.parameters = {{"bootstrap", "1000"}, {"techniques", "implicit"}};
  const Moments means = scatter(*scene, options, GetParam().seeds).means;
  const double error = std::hypot(means.standard_error(), truth.standard_error);
  EXPECT_NEAR(means.mean(), truth.value, 5.0 * error);
  EXPECT_LT(5.0 * error, 0.5 * truth.value) << "too noisy to notice what it should";
}

// As above where no population has found any: the plain samples in place of the missing chains'
// large steps must have their weight, w of the light (see `ChainItems::refine_b`). In the test
// above they are a tenth of the light, as much as its error.
TEST(RareLight, MissingChainsAreReplacedByPlainSamples) {
  const auto scene = rarely_lit(0.015);
  test::RenderOptions options = rare_options();
  const Estimate truth = rare_truth(*scene);
  options.samples = 512;
  constexpr double kLargeSteps = 0.5 * 512 * 12 * 8;
  options.parameters = {{"bootstrap", "1000"}, {"techniques", "implicit"}, {"large-step", "0.5"}};
  for (const char* integrator : {"pssmlt+", "mmlt+"}) {
    options.integrator = integrator;
    Moments means;
    double bootstrap = 0.0;
    for (options.seed = 1; options.seed <= 150; ++options.seed) {
      const test::Render render = test::render(*scene, options);
      const MethodReport report = render.integrator->report();
      if (report.at("chains") == 0) means.add(image_mean(replicates_of(render, "indirect")).value);
      bootstrap = report.at("bootstrap_samples").get<double>();
    }
    const double weight = kLargeSteps / (bootstrap + kLargeSteps);
    EXPECT_NEAR(means.mean(), weight * truth.value, 5.0 * means.standard_error()) << integrator;
    EXPECT_LT(5.0 * means.standard_error(), 0.5 * truth.value)
        << "too noisy to notice what it should";
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, RareLight,
                         ::testing::Values(RareCase{"pssmlt+", 0.03, 32, 1600},
                                           RareCase{"pssmlt+", 0.03, 10, 2400},
                                           RareCase{"mmlt+", 0.03, 32, 1600}));

}  // namespace
}  // namespace ajar
