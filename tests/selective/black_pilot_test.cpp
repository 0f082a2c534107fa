#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "support/mean_over_seeds.h"
#include "support/render.h"
#include "support/temporary_file.h"

/// Pictures that the pilot of `selective` finds black: whatever it does then, they are right on
/// average.
namespace ajar {
namespace {

std::string quad_of(const std::string& points) {
  return "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [" + points + "]\n";
}

/// A lamp behind the camera, which is seldom hit by chance, above a floor and before a wall.
std::unique_ptr<Scene> rarely_lit() {
  return test::scene_from(test::pbrt_scene(
      "LookAt 0 0 -3  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [60]\n", 8, 6,
      "AttributeBegin\nTranslate 0 3 -4\nAreaLightSource \"diffuse\" \"rgb L\" [100 100 100]\n"
      "Shape \"sphere\" \"float radius\" [0.7]\nAttributeEnd\n"
      "Material \"matte\" \"rgb Kd\" [0.7 0.7 0.7]\n" +
          quad_of("-3 -1 -6  3 -1 -6  3 -1 3  -3 -1 3") +
          quad_of("-3 -1 2  3 -1 2  3 3 2  -3 3 2")));
}

TEST(BlackPilot, LeavesThePictureRightOnAverage) {
  const test::TemporaryFile rules("rules.txt");
  std::ofstream(rules.path()) << "object * chain\n";
  const auto scene = rarely_lit();
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
  // By the technique that seldom finds it: of the 96 samples of the first pilot, hardly ever one.
  options.parameters = {{"techniques", "implicit"},
                        {"regions", rules.path()},
                        {"importance", "uniform"},
                        {"pilot", "discard"},
                        {"roulette", "usual"}};
  int renders = 0;
  int black = 0;
  int with_chains = 0;
  const auto mean = [&](std::uint64_t seed) {
    options.seed = seed;
    const test::Render render = test::render(*scene, options);
    ++renders;
    black += render.mean() == 0.0 ? 1 : 0;
    with_chains += render.counters.mutations > 0 ? 1 : 0;
    EXPECT_TRUE(render.integrator->findings().concerns.empty());
    return render.mean() / expected;
  };
  test::expect_mean_over_seeds({1.0, 0.0, 0.5}, 150, mean, "after a black pilot");
  EXPECT_GT(black, 0) << "light so rare that some pictures have none";
  EXPECT_GT(with_chains, renders / 2) << "the second pilot finds it";
}

}  // namespace
}  // namespace ajar
