#include "integrator/selective/config.h"

#include <gtest/gtest.h>

#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar {
namespace {

class SelectiveConfigTest : public ::testing::Test {
 protected:
  SelectiveConfig config(const std::map<std::string, std::string>& given = {},
                         Vec2i resolution = Vec2i(24, 18)) {
    RenderSettings settings = test::settings_of(*scene_, {.max_depth = 6});
    settings.resolution = resolution;
    settings.crop = Box2i(Vec2i(0, 0), resolution - Vec2i(1, 1));
    return {*scene_, settings, Parameters(SelectiveConfig::parameters(), given)};
  }
  std::unique_ptr<Scene> scene_ = test::scene_from(test::small_scene("Room").text);
};

TEST_F(SelectiveConfigTest, ThresholdsFollowTheSplit) {
  EXPECT_EQ(config().thresholds, (std::vector{0.1, 0.3, 1.0, 3.0, 10.0, 30.0}));
  EXPECT_EQ(config({{"split", "2"}}).thresholds, (std::vector{2.0}));
}

TEST_F(SelectiveConfigTest, SmallPicturesHaveMorePilotSamplesPerPixel) {
  EXPECT_EQ(config({}, Vec2i(24, 18)).pilot_samples, 16U);
  EXPECT_EQ(config({}, Vec2i(96, 72)).pilot_samples, 9U);
  EXPECT_EQ(config({}, Vec2i(512, 512)).pilot_samples, 4U);
}

TEST_F(SelectiveConfigTest, HasFewParameters) {
  EXPECT_LE(SelectiveConfig::parameters().size(), 14U);
}

}  // namespace
}  // namespace ajar
