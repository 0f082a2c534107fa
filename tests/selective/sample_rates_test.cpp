#include "integrator/montecarlo/sample_rates.h"

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

/// Where ordinary Monte Carlo has how many camera samples changes no expectation.
namespace ajar {
namespace {

using test::expect_same;
using test::replicates_of;

/// Errors that have nothing to do with those of the picture, and differ by any factor up to 10000
/// from one block of 8×8 pixels to the next.
std::vector<double> random_errors(const Film& film, std::uint64_t seed) {
  std::vector<double> errors;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const std::uint64_t random = hash_numbers(seed, x / 8, y / 8);
      const float u = to_unit_float(static_cast<std::uint32_t>(random >> 32U));
      errors.push_back(std::pow(10.0, 8.0 * static_cast<double>(u)));
    }
  }
  return errors;
}

/// Finds strong paths, some of them by lot, and puts them back on the film.
class HandedBack final : public OutlierSinkFactory {
 public:
  std::unique_ptr<OutlierSink> make(Film& /*film*/, Counters& /*counters*/) const override {
    return std::make_unique<Sink>();
  }

 private:
  class Sink final : public OutlierSink {
   public:
    double threshold() const override { return 0.01; }
    bool spread(SampleSource& /*numbers*/, OutlierPath& /*path*/) override { return false; }
  };
};

/// Ordinary Monte Carlo with rates that are random, and change once, and random control variates.
test::Render render_with_random_rates(const Scene& scene, const test::RenderOptions& options,
                                      const std::string& techniques, SampleRates& rates,
                                      const Divisions* divisions,
                                      const OutlierSinkFactory* strong) {
  const auto change = static_cast<std::uint64_t>(options.samples) / 4;
  return test::render_with(
      make_path_integrator(scene, test::settings_of(scene, options),
                           Parameters(path_family_parameters(path_family_defaults(techniques)), {}),
                           {.divisions = divisions, .strong = strong, .rates = &rates}),
      scene, options, [&](const Film& film, std::uint64_t samples) {
        SampleRates::Guesses guesses;
        for (const double value : random_errors(film, samples)) {
          const auto light = static_cast<float>(0.1 * std::log10(value));
          guesses.direct.insert(guesses.direct.end(), {light, light, light});
          guesses.indirect.insert(guesses.indirect.end(), {0.F, light, 0.2F});
        }
        rates.adjust(random_errors(film, samples < change ? 1 : 2), std::move(guesses), samples);
      });
}

TEST(SampleRates, ChangeNoExpectation) {
  for (const char* name : {"Room", "GlassAndMetal", "CroppedMitchell"}) {
    const auto [scene, options, truth] = test::known_picture(name, 128);
    const ImportanceMap even;
    const Divisions divisions(Division(0.003, even));
    const HandedBack strong;
    for (const char* techniques : {"pt", "ibpt", "bdpt"}) {
      for (const bool divided : {false, true}) {
        SampleRates rates(truth.film->crop(), options.replicates, 3);
        const test::Render render =
            render_with_random_rates(*scene, options, techniques, rates,
                                     divided ? &divisions : nullptr, divided ? &strong : nullptr);
        expect_same(replicates_of(render), replicates_of(truth), *render.film, 0.15,
                    std::string(name) + ", " + techniques + (divided ? ", divided" : ""));
      }
    }
  }
}

/// Error of the pixels of three renders, and their number of camera samples.
struct ErrorAndSamples {
  double error = 0.0;
  std::uint64_t samples = 0;
};

ErrorAndSamples error_of_selective(const Scene& scene, const std::string& samples) {
  test::RenderOptions options;
  options.integrator = "selective";
  options.replicates = 4;
  options.samples = 192;
  options.parameters = {{"samples", samples}};
  ErrorAndSamples result;
  for (const std::uint64_t seed : {1, 2, 3}) {
    options.seed = seed;
    const test::Render render = test::render(scene, options);
    result.samples += render.counters.samples;
    for (const double variance :
         weighted_errors(replicates_of(render), render.film->crop(), ImportanceMap()).variance) {
      result.error += std::sqrt(variance);
    }
  }
  return result;
}

TEST(SampleRates, HelpWhereHalfOfThePictureIsWithoutNoise) {
  const auto scene = test::scene_from(test::pbrt_scene(
      "LookAt 0 0 -3  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" [45]", 32, 32,
      "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\n"
      "Shape \"sphere\" \"float radius\" [0.8]\nTranslate 0.4 0.4 -0.8 Shape \"sphere\" \"float "
      "radius\" [0.3]\n"));
  const ErrorAndSamples uniform = error_of_selective(*scene, "uniform");
  const ErrorAndSamples adaptive = error_of_selective(*scene, "adaptive");
  EXPECT_LT(adaptive.error, 0.9 * uniform.error);
  const auto samples = static_cast<double>(uniform.samples);
  EXPECT_NEAR(static_cast<double>(adaptive.samples), samples, 0.01 * samples);
}

}  // namespace
}  // namespace ajar
