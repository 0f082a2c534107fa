#include <gtest/gtest.h>

#include <numeric>

#include "session/job/preparation.h"
#include "support/methods.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar {
namespace {

/// A method whose preparation is skipped.
struct Case {
  std::string integrator;
  std::map<std::string, std::string> parameters;
  int rounds;  ///< rounds that are run before the skip
};

int rounds_of(const Scene& scene, const test::RenderOptions& options) {
  const IntegratorInfo& info = find_integrator(options.integrator);
  const auto integrator =
      info.make(scene, test::settings_of(scene, options), info.read(options.parameters));
  Preparation preparation(*integrator);
  preparation.run();
  return static_cast<int>(preparation.rounds());
}

/// Chains that could not be prepared leave the whole picture to ordinary Monte Carlo, for any plan.
TEST(Unprepared, ChainsLeaveThePictureToBidirectionalPathTracing) {
  const auto scene = test::scene_from(test::small_scene("GlassAndMetal").text);
  test::RenderOptions options;
  options.samples = 16;
  options.replicates = 4;
  options.max_depth = 8;
  test::RenderOptions own_options = options;
  std::vector<Case> cases = {
      {"selective", {{"techniques", "bdpt"}}, 1},
      {"selective", {{"pilot", "discard"}}, 1},
  };
  for (const std::string& name :
       test::methods_but(test::those_without_chains("it has nothing to prepare"))) {
    std::map<std::string, std::string> parameters;
    if (name == "masked") parameters["omc"] = "bdpt";
    cases.push_back({name, parameters, 0});
    own_options.integrator = name;
    if (rounds_of(*scene, own_options) > 1) cases.push_back({name, parameters, 1});
  }
  for (const Case& c : cases) {
    SCOPED_TRACE(c.integrator + " after " + std::to_string(c.rounds));
    test::RenderOptions own = options;
    own.integrator = c.integrator;
    own.parameters = c.parameters;
    own.skip_after = c.rounds;
    own.aovs = {"density", "depth"};
    const auto render = test::render(*scene, own);
    test::RenderOptions plain = options;
    plain.integrator = "bdpt";
    const std::vector<float> expected = test::render(*scene, plain).image();
    const std::vector<float> found = render.image();
    const float mean = std::accumulate(expected.begin(), expected.end(), 0.F) /
                       static_cast<float>(expected.size());
    ASSERT_GT(mean, 0.F);
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_NEAR(found[i], expected[i], 1e-4F * (mean + expected[i])) << "pixel " << i / 3;
    }
    for (const float visits : render.layer("density")) ASSERT_EQ(visits, 0.F);
    EXPECT_EQ(render.counters.mutations, 0U);
    EXPECT_FALSE(render.integrator->keeps_state());
    EXPECT_EQ(render.integrator->findings().notes.size(), 1U);
  }
}

}  // namespace
}  // namespace ajar
