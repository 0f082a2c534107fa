#include "integrator/montecarlo/efficient_roulette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/random.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/montecarlo/weighted_errors.h"
#include "support/render.h"
#include "support/same_picture.h"

/// Roulette of rays with small contributions: no expectation changes, and efficiency improves.
namespace ajar {
namespace {

using test::expect_same;
using test::replicates_of;

/// Weights that differ by up to 30 times from pixel to pixel.
ImportanceMap random_importance(const Box2i& crop) {
  std::vector<float> weights;
  for (int y = crop.min.y; y <= crop.max.y; ++y) {
    for (int x = crop.min.x; x <= crop.max.x; ++x) {
      const auto random = static_cast<std::uint32_t>(hash_numbers(7, x, y) >> 32U);
      weights.push_back(std::pow(30.F, to_unit_float(random)));
    }
  }
  return {crop, weights};
}

/// The price goes up and down as the samples grow.
test::Render render_at_price(const Scene& scene, const test::RenderOptions& options,
                             const std::string& techniques, const ImportanceMap& importance,
                             double height, double brightness) {
  const RenderSettings settings = test::settings_of(scene, options);
  EfficientRoulette roulette(scene.bounds(), settings.crop, brightness);
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  return test::render_with(
      make_path_integrator(scene, settings,
                           Parameters(path_family_parameters(path_family_defaults(techniques)), {}),
                           {.roulette = &roulette}),
      scene, options, [&](const Film& /*film*/, std::uint64_t samples) {
        const double change = samples % 3 == 0 ? 0.3 : 2.0;
        roulette.end_round(
            importance, std::vector<double>(pixels, std::pow(change * height * brightness, 2.0)));
      });
}

TEST(EfficientRoulette, ChangesNoExpectation) {
  for (const char* name : {"Room", "GlassAndMetal", "CroppedMitchell"}) {
    const auto [scene, options, truth] = test::known_picture(name, 256);
    const ImportanceMap importance = random_importance(truth.film->crop());
    for (const char* techniques : {"pt", "ibpt", "bdpt"}) {
      std::map<double, double> rays;
      for (const double height : {0.1, 2.0}) {
        const test::Render render =
            render_at_price(*scene, options, techniques, importance, height, truth.mean());
        expect_same(replicates_of(render), replicates_of(truth), *render.film, 0.15,
                    std::string(name) + ", " + techniques + ", " + std::to_string(height));
        rays[height] = static_cast<double>(render.counters.rays);
      }
      EXPECT_LT(rays[2.0], 0.9 * rays[0.1]) << name << ", " << techniques << ": nothing saved";
    }
  }
}

/// Squared relative error · rays: says how long a picture of a given error takes.
double cost_of_precision(const Scene& scene, const std::string& roulette) {
  test::RenderOptions options;
  options.integrator = "selective";
  options.replicates = 4;
  options.samples = 24;
  options.max_depth = 16;
  options.parameters = {{"techniques", "ibpt"}, {"roulette", roulette}};
  const test::Render render = test::render(scene, options);
  const std::vector<float> image = render.image();
  std::vector<float> luminances;
  for (std::size_t i = 0; i < image.size(); i += 3) {
    luminances.push_back(luminance(Spectrum(image[i], image[i + 1], image[i + 2])));
  }
  const Box2i& crop = render.film->crop();
  const WeightedErrors errors =
      weighted_errors(replicates_of(render), crop, ImportanceMap::relative(crop, luminances));
  return sum_of(trimmed(errors.variance)) * static_cast<double>(render.counters.rays);
}

/// Measured: 0.77 at 128×96 pixels, four seeds.
TEST(EfficientRoulette, PaysInABathroom) {
  const Scene scene = test::builtin_scene("bathroom");
  EXPECT_LT(cost_of_precision(scene, "efficient"), 0.9 * cost_of_precision(scene, "usual"));
}

}  // namespace
}  // namespace ajar
