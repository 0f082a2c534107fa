#include "integrator/selective/chain_plan.h"

#include <gtest/gtest.h>

#include "support/render.h"
#include "support/small_scenes.h"

/// Plans of renders with chains.
namespace ajar {
namespace {

class ChainPlanTest : public ::testing::Test {
 protected:
  std::vector<double> thresholds(std::optional<SelectiveSettings> selective,
                                 const std::map<std::string, std::string>& given = {}) {
    return ChainPlan(ChainKind::OnePath, *scene_, test::settings_of(*scene_, {.max_depth = 6}),
                     Parameters(chain_parameters(ChainKind::OnePath), given), std::move(selective))
        .thresholds;
  }
  std::unique_ptr<Scene> scene_ = test::scene_from(test::small_scene("Room").text);
};

TEST_F(ChainPlanTest, RegionsMayLeaveChainsLessThanAWholePicture) {
  EXPECT_EQ(thresholds({}), (std::vector{0.1, 0.3, 1.0, 3.0, 10.0}));
  EXPECT_EQ(thresholds(SelectiveSettings{}), (std::vector{0.1, 0.3, 1.0, 3.0, 10.0, 30.0}));
}

TEST_F(ChainPlanTest, ThresholdsFollowTheUser) {
  EXPECT_EQ(thresholds({}, {{"split", "2"}}), (std::vector{2.0}));
  EXPECT_EQ(thresholds(SelectiveSettings{}, {{"split", "2"}}), (std::vector{2.0, 6.0, 20.0}));
  EXPECT_TRUE(thresholds(SelectiveSettings{}, {{"split", "0"}}).empty());
}

TEST_F(ChainPlanTest, APilotOfASmallPictureHasMoreSamplesOfEachPixel) {
  RenderSettings settings = test::settings_of(*scene_, {.max_depth = 6});
  const auto samples_of = [&](Vec2i resolution, const SelectiveSettings& selective) {
    settings.resolution = resolution;
    settings.crop = Box2i(Vec2i(0, 0), resolution - Vec2i(1, 1));
    return ChainPlan(ChainKind::OnePath, *scene_, settings,
                     Parameters(chain_parameters(ChainKind::OnePath), {}), selective)
        .pilot_samples;
  };
  EXPECT_EQ(samples_of(Vec2i(24, 18), {}), 16U);
  EXPECT_EQ(samples_of(Vec2i(96, 72), {}), 9U);
  EXPECT_EQ(samples_of(Vec2i(512, 512), {}), 4U);
  EXPECT_EQ(samples_of(Vec2i(24, 18), {.pilot_samples = 6}), 6U) << "as the user says";
}

}  // namespace
}  // namespace ajar
