#include "integrator/selective/brightness_pilot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/render.h"
#include "support/small_scenes.h"

/// Brightness of a picture from squares of its pixels, camera samples and light subpaths alike.
namespace ajar {
namespace {

struct Looked {
  BrightnessPilot::Result result;
  Counters counters;
};

Looked look(const Scene& scene, const std::string& techniques, Vec2i resolution) {
  RenderSettings settings = test::settings_of(scene, {.max_depth = 6});
  settings.resolution = resolution;
  settings.crop = Box2i(Vec2i(0, 0), resolution - Vec2i(1, 1));
  const SelectivePreparation prepared(
      SelectiveConfig(scene, settings,
                      Parameters(SelectiveConfig::parameters(),
                                 {{"techniques", techniques}, {"importance", "uniform"}})));
  BrightnessPilot pilot(prepared);
  Looked looked;
  const std::uint64_t items = pilot.begin();
  for (std::uint64_t item = 0; item < items; ++item) pilot.run(item, looked.counters);
  pilot.end();
  looked.result = pilot.take();
  return looked;
}

/// At 96x72 pixels, squares have a side of 2.
TEST(BrightnessPilot, TellsTheMeanOfThePicture) {
  const Scene scene = test::builtin_scene("cornell");
  const Vec2i resolution = scene.camera().resolution();
  test::RenderOptions options;
  options.integrator = "bdpt";
  options.max_depth = 6;
  const test::Render truth = test::render(scene, options);
  double expected = 0.0;
  const std::vector<float> image = truth.image();
  for (std::size_t i = 0; i < image.size(); i += 3) {
    expected += static_cast<double>(luminance(Spectrum(image[i], image[i + 1], image[i + 2])));
  }
  expected /= static_cast<double>(image.size() / 3);
  for (const char* techniques : {"pt", "ibpt", "bdpt", "lt"}) {
    const Looked looked = look(scene, techniques, resolution);
    // Light tracing does not see the lamp itself.
    if (std::string(techniques) != "lt") {
      EXPECT_NEAR(looked.result.brightness, expected, 0.15 * expected) << techniques;
    }
    EXPECT_EQ(looked.result.first_look.size(), image.size());
    EXPECT_GT(looked.result.scale.mean, 0.2 * expected) << techniques;
    EXPECT_LT(looked.result.scale.mean, 5.0 * expected) << techniques;
  }
}

}  // namespace
}  // namespace ajar
