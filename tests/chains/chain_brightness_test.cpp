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
#include "imageio/image_file.h"
#include "mcmc/moments.h"
#include "support/methods.h"
#include "support/render.h"
#include "support/same_picture.h"
#include "support/small_scenes.h"

/// Brightness of pictures by chains, for any importance map, and its scatter.
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
    write_image(
        path(),
        {{width, height}, Box2i({0, 0}, {width - 1, height - 1}), {{"", 3, std::move(rgb)}}, {}});
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
  // Both halves weigh by the map what they share.
  options.integrator = "selective";
  for (const char* chain : {"mmlt", "mlt"}) {
    for (const std::string& map : {std::string("relative"), noise.path()}) {
      options.parameters = {{"chain", chain}, {"split", "0.5"}, {"importance", map}};
      const test::Render render = test::render(*scene, options);
      expect_same(replicates_of(render, "indirect"), truth, *render.film, 0.4,
                  std::string("selective, chain ") + chain + ", importance " + map);
    }
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
  options.integrator = "selective";
  options.parameters = {{"split", "0.5"}};
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
  int seeds = 0;

  void render_up_to(int all, const Scene& scene, test::RenderOptions options) {
    while (seeds < all) {
      options.seed = static_cast<std::uint64_t>(++seeds);
      const Estimate mean = image_mean(replicates_of(test::render(scene, options), "indirect"));
      means.add(mean.value);
      error_variance.add(mean.standard_error * mean.standard_error);
    }
  }
  /// ½ ln F, where F is the variance of means over that of error bars. It is nearly normal
  /// (Fisher's z).
  double log_ratio() const {
    const double between = means.standard_error() * means.standard_error() * seeds;
    return 0.5 * std::log(between / error_variance.mean());
  }
  /// Standard deviation of `log_ratio`, with `replicates` in each error bar.
  double deviation(int replicates) const {
    return std::sqrt(0.5 * (1.0 / (seeds - 1.0) + 1.0 / (seeds * (replicates - 1.0))));
  }
};

class OverSeeds : public ::testing::TestWithParam<std::string> {};

TEST_P(OverSeeds, BrightnessScattersWithinErrorBars) {
  // Published chains know b from the bootstrap alone, to which caustics are rare.
  const bool has_rare_caustics =
      GetParam() == "mmlt" || GetParam() == "pssmlt" || GetParam() == "masked";
  const auto scene =
      test::scene_from(small_scene(has_rare_caustics ? "Room" : "NestedDielectrics").text);
  test::RenderOptions options;
  options.replicates = 8;
  options.max_depth = 6;
  // Chains of explicit paths, and those without ordinary Monte Carlo, scatter twice as much.
  const bool scatters = has_rare_caustics || GetParam() == "mlt" || GetParam() == "erpt";
  options.samples = scatters ? 40 : 16;
  options.integrator = GetParam();
  if (test::has_parameter(GetParam(), "bootstrap")) {
    options.parameters["bootstrap"] = scatters ? "8000" : "4000";
  }
  test::RenderOptions reference = options;
  reference.integrator = "bdpt";
  reference.parameters = {};
  reference.samples = 1536;
  reference.seed = 1;
  const Estimate truth = image_mean(replicates_of(test::render(*scene, reference), "indirect"));

  // Two effects are to be noticed: error bars wrong by half, and a mean wrong by 6 %.
  const double log_effect = std::log(2.0);
  const double mean_effect = 0.06 * truth.value;
  Scatter chains;
  const auto error = [&] {
    return std::hypot(truth.standard_error, chains.means.standard_error());
  };
  // A first look ends the test if both effects are 2.4 standard deviations away, which each is by
  // mistake once in 120 times.
  chains.render_up_to(32, *scene, options);
  const bool clear =
      std::abs(chains.log_ratio()) + 2.4 * chains.deviation(options.replicates) < log_effect &&
      std::abs(chains.means.mean() - truth.value) + 2.4 * error() < mean_effect;
  if (clear) return;
  chains.render_up_to(100, *scene, options);
  EXPECT_LT(std::abs(chains.log_ratio()), 5.0 * chains.deviation(options.replicates));
  EXPECT_NEAR(chains.means.mean(), truth.value, 5.0 * error());
  EXPECT_LT(5.0 * error(), mean_effect) << "too noisy to notice what it should";
}

INSTANTIATE_TEST_SUITE_P(
    Chains, OverSeeds,
    ::testing::ValuesIn(test::methods_but(test::those_without_chains("it has no b"))),
    [](const auto& test) { return test::name_for_tests(test.param); });

}  // namespace
}  // namespace ajar
