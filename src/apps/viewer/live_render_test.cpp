#include "apps/viewer/live_render.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "core/error.h"

namespace ajar::viewer {
namespace {

using std::chrono::milliseconds;

class LiveRenderTest : public ::testing::Test, public LiveRender::Listener {
 protected:
  void begin(const std::string& scene, const std::string& integrator, int width = 32) {
    RenderSpec spec;
    spec.integrator = integrator;
    spec.resolution = {width, width};
    spec.max_depth = 5;
    live_ = std::make_unique<LiveRender>(LiveRender::Options{scene, spec}, *this);
  }
  bool wants_picture() override { return true; }
  void changed() override {}
  void note(bool /*is_warning*/, const std::string& /*text*/) override {}

  template <typename Holds>
  bool waits_until(Holds holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < end) {
      if (holds(live_->status())) return true;
      std::this_thread::sleep_for(milliseconds(5));
    }
    return false;
  }
  bool has_samples(double samples) {
    return waits_until([&](const LiveStatus& status) { return status.samples >= samples; });
  }
  double mean() const {
    const auto picture = live_->picture().picture;
    double sum = 0.0;
    for (const float value : picture->layers.front().pixels) sum += static_cast<double>(value);
    return sum / static_cast<double>(picture->layers.front().pixels.size());
  }

  std::unique_ptr<LiveRender> live_;
};

TEST_F(LiveRenderTest, RendersUntilALimitAndGoesOn) {
  begin("builtin:cornell", "pt");
  live_->stop_at({.samples = 8.0, .seconds = {}, .error = {}});
  ASSERT_TRUE(
      waits_until([](const LiveStatus& status) { return status.phase == LivePhase::Paused; }));
  const double samples = live_->status().samples;
  EXPECT_GE(samples, 8.0);
  std::this_thread::sleep_for(milliseconds(100));
  EXPECT_EQ(live_->status().samples, samples) << "it does not render while it waits";
  live_->pause(false);
  EXPECT_TRUE(has_samples(samples + 1.0));
}

TEST_F(LiveRenderTest, RegionsKeepWhatWasRendered) {
  begin("builtin:cornell", "selective");
  ASSERT_TRUE(has_samples(24.0));
  const std::uint32_t epoch = live_->status().epoch;
  const double expected = mean();
  live_->change([](LiveState& state) { state.rules = {{"object", "*", "omc"}}; });
  ASSERT_TRUE(waits_until([](const LiveStatus& status) {
    return status.phase == LivePhase::Rendering && status.samples > 48.0;
  }));
  EXPECT_EQ(live_->status().epoch, epoch);
  // A second change: of three epochs.
  live_->change([](LiveState& state) { state.rules.clear(); });
  ASSERT_TRUE(waits_until([](const LiveStatus& status) {
    return status.phase == LivePhase::Rendering && status.samples > 72.0;
  }));
  EXPECT_NEAR(mean(), expected, 0.05 * expected);
}

TEST_F(LiveRenderTest, AllEpochsCount) {
  begin("builtin:cornell", "selective");
  const auto is_paused = [](const LiveStatus& status) { return status.phase == LivePhase::Paused; };
  // Passes end there, whatever their length.
  constexpr double kMilestone = 16.0;
  const auto own_samples = [this] {
    return *metadata_number(*live_->picture().picture, "ajar:samples_per_pixel");
  };
  live_->stop_at({.samples = kMilestone, .seconds = {}, .error = {}});
  ASSERT_TRUE(waits_until(is_paused));
  ASSERT_EQ(own_samples(), kMilestone);
  live_->change([](LiveState& state) { state.rules = {{"object", "*", "auto"}}; });
  live_->stop_at({.samples = 3.0 * kMilestone, .seconds = {}, .error = {}});
  ASSERT_TRUE(waits_until([&](const LiveStatus& status) {
    return is_paused(status) && status.samples >= 3.0 * kMilestone;
  }));
  EXPECT_GE(live_->status().samples, kMilestone + own_samples());
}

/// Epochs of the same numbers would add nothing to each other.
TEST_F(LiveRenderTest, NoTwoRendersHaveTheSameNumbers) {
  begin("builtin:cornell", "pt");
  const auto is_paused = [](const LiveStatus& status) { return status.phase == LivePhase::Paused; };
  live_->stop_at({.samples = 16.0, .seconds = {}, .error = {}});
  ASSERT_TRUE(waits_until(is_paused));
  const LivePicture first = live_->picture();
  live_->restart();
  ASSERT_TRUE(waits_until([&](const LiveStatus& status) {
    return is_paused(status) && live_->picture().epoch > first.epoch &&
           live_->picture().picture != first.picture;
  }));
  const auto second = live_->picture().picture;
  ASSERT_EQ(metadata_number(*second, "ajar:samples_per_pixel"),
            metadata_number(*first.picture, "ajar:samples_per_pixel"));
  EXPECT_NE(second->layers.front().pixels, first.picture->layers.front().pixels);
}

TEST_F(LiveRenderTest, APassThatIsCutShortIsForgotten) {
  begin("builtin:cornell", "selective", 300);
  const auto is_whole = [this] {
    const auto picture = live_->picture().picture;
    return picture == nullptr || !picture->metadata.contains("ajar:complete") ||
           picture->metadata.at("ajar:complete") == "true";
  };
  int cut = 0;
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(waits_until([](const LiveStatus& status) {
      return status.phase == LivePhase::Rendering && status.samples > 0.0;
    }));
    // The second does not wait for the pass of the first.
    live_->change([](LiveState& state) { state.rules = {{"object", "*", "omc"}}; });
    live_->change([](LiveState& state) { state.rules.clear(); });
    cut += waits_until([&](const LiveStatus& status) {
      return !is_whole() || status.phase == LivePhase::Preparing;
    });
    ASSERT_TRUE(is_whole());
  }
  EXPECT_EQ(cut, 2);
}

TEST_F(LiveRenderTest, OtherPicturesBeginAnewAndCanBeUndone) {
  begin("builtin:cornell", "pt");
  ASSERT_TRUE(has_samples(4.0));
  const LiveStatus before = live_->status();
  const double light = mean();
  live_->change([&](LiveState& state) {
    state.camera = before.camera;
    state.camera->position.z -= 1.F;
  });
  ASSERT_TRUE(waits_until([&](const LiveStatus& status) {
    return status.epoch > before.epoch && status.phase == LivePhase::Rendering &&
           status.samples >= 4.0;
  }));
  EXPECT_TRUE(live_->status().can_undo);
  EXPECT_GT(std::abs(mean() - light), 0.1 * light) << "it shows something else";
  live_->undo();
  ASSERT_TRUE(waits_until([&](const LiveStatus& status) {
    return status.epoch > before.epoch + 1 && status.phase == LivePhase::Rendering &&
           status.samples >= 16.0;
  }));
  EXPECT_NEAR(mean(), light, 0.1 * light);
  EXPECT_FALSE(live_->status().can_undo);
  EXPECT_TRUE(live_->status().can_redo);
}

TEST_F(LiveRenderTest, StepsOfAMouseAreUndoneTogether) {
  begin("builtin:cornell", "pt");
  ASSERT_TRUE(has_samples(1.0));
  const CameraPose first = live_->status().camera;
  for (int i = 1; i <= 5; ++i) {
    live_->change(
        [&](LiveState& state) {
          state.camera = first;
          state.camera->position.x += 0.01F * static_cast<float>(i);
        },
        i < 5);
  }
  live_->undo();
  EXPECT_EQ(live_->status().camera.position, first.position);
  EXPECT_FALSE(live_->status().can_undo);
}

TEST_F(LiveRenderTest, AMovingCameraShowsASmallPicture) {
  begin("builtin:cornell", "selective", 640);
  ASSERT_TRUE(waits_until([&](const LiveStatus&) { return live_->picture().picture != nullptr; }));
  const CameraPose first = live_->status().camera;
  const auto move = [&](float by, bool is_passing) {
    live_->change(
        [&](LiveState& state) {
          state.camera = first;
          state.camera->position.x += by;
        },
        is_passing);
  };
  move(0.1F, true);
  ASSERT_TRUE(waits_until([&](const LiveStatus&) { return live_->picture().coarseness == 2; }));
  EXPECT_EQ(live_->picture().picture->resolution, Vec2i(320, 320));
  EXPECT_EQ(live_->status().resolution, Vec2i(640, 640)) << "that of the image";
  move(0.2F, false);
  ASSERT_TRUE(waits_until([&](const LiveStatus&) { return live_->picture().coarseness == 1; }));
  EXPECT_EQ(live_->picture().picture->resolution, Vec2i(640, 640));
}

TEST_F(LiveRenderTest, TellsWhatFailsAndGoesOn) {
  begin("builtin:cornell", "selective");
  ASSERT_TRUE(has_samples(1.0));
  live_->change([](LiveState& state) { state.rules = {{"object", "nothing", "omc"}}; });
  ASSERT_TRUE(
      waits_until([](const LiveStatus& status) { return status.phase == LivePhase::Failed; }));
  EXPECT_NE(live_->status().message.find("nothing"), std::string::npos);
  live_->undo();
  EXPECT_TRUE(
      waits_until([](const LiveStatus& status) { return status.phase == LivePhase::Rendering; }));
}

TEST_F(LiveRenderTest, ASceneThatIsNotThereIsAnError) {
  EXPECT_THROW(begin("no-such-scene.pbrt", "pt"), IoError);
}

TEST(LiveEpochs, AreAddedBySamples) {
  Picture a;
  a.resolution = {1, 1};
  a.crop = Box2i(Vec2i(0, 0), Vec2i(0, 0));
  a.layers = {{"", 3, {1.F, 2.F, 3.F}}, {"depth", 1, {5.F}}};
  Picture b = a;
  b.layers = {{"", 3, {5.F, 2.F, 7.F}}, {"depth", 1, {9.F}}};
  const Picture sum = add_epochs(a, 3.0, b, 1.0);
  EXPECT_EQ(sum.layers[0].pixels, (std::vector<float>{2.F, 2.F, 4.F}));
  EXPECT_EQ(sum.layers[1].pixels, (std::vector<float>{9.F})) << "no light";
}

TEST(CameraPoseTest, StandsWhereTheCameraDoes) {
  desc::Camera camera;
  camera.node = desc::PerspectiveCamera{};
  const CameraPose pose{Vec3(1, 2, 3), Vec3(1, 2, 8), Vec3(0, 1, 0), 50.F, 0.1F, 5.F};
  move_camera(camera, pose);
  const CameraPose back = pose_of(camera, Box3());
  EXPECT_EQ(back.position, pose.position);
  EXPECT_NEAR(length(back.target - pose.target), 0.F, 1e-5F);
  EXPECT_EQ(back.fov, 50.F);
  EXPECT_FALSE(swaps_handedness(camera.to_world));
  for (int i = 0; i < 3; ++i) camera.to_world[0][i] *= -1.0;
  move_camera(camera, pose);
  EXPECT_TRUE(swaps_handedness(camera.to_world)) << "a mirrored camera stays so";
}

}  // namespace
}  // namespace ajar::viewer
