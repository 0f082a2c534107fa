#include "measuring/timed_render.h"

#include <gtest/gtest.h>

#include <cmath>

#include "session/render/resolved_render.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar::bench {
namespace {

class TimedRenderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    scene_ = test::scene_from(test::small_scenes().front().text);
    settings_ = settings_for(*scene_);
    settings_.max_depth = 4;
  }

  std::unique_ptr<Scene> scene_;
  RenderSettings settings_;
  const Variant variant_ = parse_variant("pt");
};

TEST_F(TimedRenderTest, UsesItsTimeLimit) {
  const InterruptCount nobody{0};
  const TimedRender render = render_for({0.4, 2}, *scene_, variant_, settings_, nobody);
  EXPECT_GE(render.cpu_seconds, 0.4);
  // Passes take as long as the machine and sanitizers need; this is about ending at all.
  EXPECT_LT(render.cpu_seconds, 30.0);
  EXPECT_GE(render.samples, 1U);
  EXPECT_TRUE(render.complete);
  const auto values = 3U * static_cast<std::size_t>(settings_.resolution.x) *
                      static_cast<std::size_t>(settings_.resolution.y);
  EXPECT_EQ(render.picture.size(), values);
  EXPECT_EQ(render.standard_error.size(), values);
}

TEST_F(TimedRenderTest, StopsOnRequest) {
  const InterruptCount user{1};
  const TimedRender render = render_for({1e6, 1}, *scene_, variant_, settings_, user);
  EXPECT_LT(render.cpu_seconds, 60.0);
}

}  // namespace
}  // namespace ajar::bench
