#include "session/job/pass_queue.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <thread>

namespace ajar {
namespace {

class PassQueueTest : public ::testing::Test {
 protected:
  /// Asks like another thread.
  std::future<bool> asked(PassQueue::Look look) {
    return std::async(std::launch::async,
                      [this, look = std::move(look)]() mutable { return passes_.ask(look); });
  }
  void wait_until_asked() {
    while (!passes_.wants_picture(state_)) std::this_thread::yield();
  }

  PassQueue passes_;
  const Film film_{Vec2i(2, 2),
                   Box2i(Vec2i(0, 0), Vec2i(1, 1)),
                   Filter::box(),
                   1,
                   {LayerSpec{.name = "direct"}}};
  JobState state_;
};

TEST_F(PassQueueTest, AnswersOnTheThreadThatRenders) {
  passes_.open();
  state_.samples_per_pixel = 7;
  std::thread::id seen_by;
  auto answer = asked([&](const Film&, const JobState& state) {
    seen_by = std::this_thread::get_id();
    EXPECT_EQ(state.samples_per_pixel, 7U);
  });
  wait_until_asked();
  passes_.see_picture(film_, state_);
  EXPECT_TRUE(answer.get());
  EXPECT_EQ(seen_by, std::this_thread::get_id());
  EXPECT_FALSE(passes_.wants_picture(state_));
}

TEST_F(PassQueueTest, RaisesWhereItWasAsked) {
  passes_.open();
  auto answer =
      asked([](const Film&, const JobState&) { throw std::runtime_error("no memory, say"); });
  wait_until_asked();
  EXPECT_NO_THROW(passes_.see_picture(film_, state_));
  EXPECT_THROW(answer.get(), std::runtime_error);
}

TEST_F(PassQueueTest, ServesThoseWhoWaitAtTheEnd) {
  passes_.open();
  auto answer = asked([](const Film&, const JobState&) {});
  wait_until_asked();
  passes_.close(film_, state_);
  EXPECT_TRUE(answer.get());
  EXPECT_FALSE(asked([](const Film&, const JobState&) {}).get());
}

TEST_F(PassQueueTest, LetsThemGoIfThereIsNoEnd) {
  passes_.open();
  auto answer = asked([](const Film&, const JobState&) { FAIL(); });
  wait_until_asked();
  passes_.close();
  EXPECT_FALSE(answer.get());
}

TEST_F(PassQueueTest, DoesNotWaitForItself) {
  const auto look = [](const Film&, const JobState&) { FAIL(); };
  EXPECT_FALSE(passes_.ask(look));
  passes_.open();
  EXPECT_FALSE(passes_.ask(look));
}

}  // namespace
}  // namespace ajar
