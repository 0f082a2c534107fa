#include "integrator/ray_price.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/random.h"
#include "integrator/path_family.h"
#include "integrator/weighted_errors.h"
#include "support/render.h"
#include "support/same_picture.h"
#include "support/small_scenes.h"

/// Roulette that saves rays where they bring little: no expectation changes, and it pays.
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

TEST(RayPrice, OfAnyHeightChangesNoExpectation) {
  for (const char* name : {"Room", "GlassAndMetal", "CroppedMitchell"}) {
    const test::SmallScene small = test::small_scene(name);
    const auto scene = test::scene_from(small.text);
    test::RenderOptions options;
    options.replicates = 16;
    options.max_depth = 6;
    options.samples = 512;
    options.crop = small.crop;
    options.integrator = "bdpt";
    const test::Render truth = test::render(*scene, options);
    options.seed = 2;
    const ImportanceMap importance = random_importance(truth.film->crop());
    const double brightness = truth.mean();
    std::uint64_t most_rays = 0;
    for (const double height : {0.01, 0.5}) {
      for (const char* techniques : {"pt", "ibpt", "bdpt"}) {
        RayPrice price(importance, height * brightness, brightness);
        const test::Render render = test::render_with(
            make_path_integrator(
                *scene, test::settings_of(*scene, options),
                Parameters(path_family_parameters(path_family_defaults(techniques)), {}),
                {.price = &price}),
            *scene, options, [&](const Film& /*film*/, std::uint64_t samples) {
              // Up and down, by the samples that are there.
              const double change = samples % 3 == 0 ? 0.3 : 2.0;
              price.adjust(std::vector<double>{std::pow(change * height * brightness, 2.0)}, 1.0);
            });
        expect_same(replicates_of(render), replicates_of(truth), *render.film, 0.15,
                    std::string(name) + ", " + techniques + ", " + std::to_string(height));
        if (std::string(techniques) != "bdpt") continue;
        if (most_rays > 0) {
          EXPECT_LT(render.counters.rays, most_rays * 9 / 10) << name << ": nothing was saved";
        }
        most_rays = render.counters.rays;
      }
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
  options.parameters = {{"omc", "ibpt"}, {"techniques", "ibpt"}, {"roulette", roulette}};
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
TEST(RayPrice, PaysInABathroom) {
  const Scene scene = test::builtin_scene("bathroom");
  EXPECT_LT(cost_of_precision(scene, "efficient"), 0.9 * cost_of_precision(scene, "usual"));
}

}  // namespace
}  // namespace ajar
