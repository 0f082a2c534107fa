#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/render.h"
#include "support/temporary_file.h"

/// A bootstrap without light counts in the mean like others: a method that did something else then
/// would make pictures that are too bright on average.
namespace ajar {
namespace {

constexpr int kRenders = 300;

std::string quad(const std::string& points) {
  return "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [" + points + "]\n";
}

/// A lamp behind the camera, which is seldom hit by chance, above a floor; and `rest`.
std::unique_ptr<Scene> rarely_lit(const std::string& radius, const std::string& rest) {
  return test::scene_from(test::pbrt_scene(
      "LookAt 0 0 -3  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [60]\n", 8, 6,
      "AttributeBegin\nTranslate 0 3 -4\nAreaLightSource \"diffuse\" \"rgb L\" [100 100 100]\n"
      "Shape \"sphere\" \"float radius\" [" +
          radius +
          "]\nAttributeEnd\n"
          "Material \"matte\" \"rgb Kd\" [0.7 0.7 0.7]\n" +
          quad("-3 -1 -6  3 -1 -6  3 -1 3  -3 -1 3") + rest));
}

TEST(UnlitChains, CountInTheMean) {
  const test::TemporaryFile rules("rules.txt");
  std::ofstream(rules.path()) << "object * chain\n";
  const auto scene = rarely_lit("0.4", quad("-3 -1 2  3 -1 2  3 3 2  -3 3 2"));
  test::RenderOptions truth;
  truth.integrator = "bdpt";
  truth.samples = 4096;
  truth.min_depth = truth.max_depth = 3;
  const double expected = test::render(*scene, truth).mean();

  test::RenderOptions options;
  options.integrator = "selective";
  options.samples = 8;
  options.replicates = 4;
  options.min_depth = options.max_depth = 3;
  // Chains make all of it, from a bootstrap by the technique that seldom finds it.
  options.parameters = {{"chain", "pssmlt"},       {"techniques", "implicit"},
                        {"bootstrap", "1000"},     {"regions", rules.path()},
                        {"importance", "uniform"}, {"pilot", "discard"},
                        {"roulette", "usual"},     {"samples", "uniform"}};
  double sum = 0.0;
  double squares = 0.0;
  int unlit = 0;
  for (int i = 0; i < kRenders; ++i) {
    options.seed = static_cast<std::uint64_t>(i) + 1;
    const test::Render render = test::render(*scene, options);
    const double mean = render.mean() / expected;
    sum += mean;
    squares += mean * mean;
    const Findings found = render.integrator->findings();
    const bool is_unlit =
        !found.notes.empty() && found.notes.front().find("no difficult light found") == 0;
    if (is_unlit) ++unlit;
    EXPECT_TRUE(found.concerns.empty());
  }
  const double mean = sum / kRenders;
  const double error = std::sqrt((squares / kRenders - mean * mean) / (kRenders - 1));
  EXPECT_GT(unlit, kRenders / 5) << "too few to matter";
  EXPECT_LT(unlit, kRenders - kRenders / 5);
  EXPECT_LT(5.0 * error, 0.5) << "too noisy to notice what it is for";
  EXPECT_LT(std::abs(mean - 1.0), 5.0 * error) << mean << " +- " << error;
}

/// A spot that a lamp behind a pane lights, seen through another: no connection makes any of its
/// light, and few camera paths come to it.
std::unique_ptr<Scene> rarely_lit_through_panes() {
  return test::scene_from(test::pbrt_scene(
      "LookAt 0 0 -3  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [60]\n", 8, 6,
      "AttributeBegin\nTranslate 0 3 -4\nAreaLightSource \"diffuse\" \"rgb L\" [100 100 100]\n"
      "Shape \"sphere\" \"float radius\" [0.8]\nAttributeEnd\n"
      "Material \"matte\" \"rgb Kd\" [0.7 0.7 0.7]\n" +
          quad("-0.4 -0.4 0  0.5 -0.4 0  0.5 0.5 0  -0.4 0.5 0") +
          "Material \"glass\" \"float index\" [1.1]\n" + quad("-9 2 -9  9 2 -9  9 2 9  -9 2 9") +
          quad("-9 -9 -2.5  9 -9 -2.5  9 1.9 -2.5  -9 1.9 -2.5")));
}

/// Plain samples replace chains without seeds after a black pilot: those of numbers, whose b
/// includes them, and not those of explicit paths, whose b is from the bootstrap alone.
TEST(UnlitChains, OfNumbersAloneTakePlainSamplesAfterABlackPilot) {
  const auto scene = rarely_lit_through_panes();
  test::RenderOptions options;
  options.integrator = "selective";
  options.samples = 8;
  options.replicates = 4;
  options.min_depth = 4;
  options.max_depth = 6;
  options.parameters = {{"bootstrap", "1000"}, {"omc", "bdpt"}};
  int of_numbers = 0;
  int of_paths = 0;
  for (options.seed = 1; options.seed <= 40; ++options.seed) {
    const MethodReport report = test::render(*scene, options).integrator->report();
    if (report["selective"]["pilot_samples_per_pixel"] != 0) continue;
    for (const auto& group : report["acceptance"]["by_depth"]) {
      if (group["chains"] != 0) continue;
      const bool has_paths = group["depth"].is_null();  // one group for all depths
      ++(has_paths ? of_paths : of_numbers);
      EXPECT_EQ(group["mutations"] == 0, has_paths) << "seed " << options.seed;
    }
  }
  EXPECT_GT(of_paths, 4);
  EXPECT_GT(of_numbers, 4);
}

}  // namespace
}  // namespace ajar
