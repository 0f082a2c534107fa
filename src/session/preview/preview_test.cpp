#include "session/preview/preview.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

#include "core/error.h"
#include "core/testing/wait_until.h"
#include "session/job/render_job.h"
#include "session/preview/tev_packets.h"
#include "session/testing/fake_viewer.h"
#include "session/testing/test_integrator.h"

namespace ajar {
namespace {

using namespace std::chrono_literals;
using Manners = FakeViewer::Manners;

const Vec2i kSize(300, 170);
const Box2i kCrop(Vec2i(5, 3), Vec2i(284, 160));  // 3 × 2 regions
constexpr int kReplicates = 4;

class PreviewTest : public ::testing::Test {
 protected:
  PreviewTest()
      : integrator_(kCrop.size() + Vec2i(1, 1), kReplicates),
        film_(kSize, kCrop, Filter::box(), kReplicates, integrator_.layers()) {
    add(Vec2i(5, 3), 1.F);
    add(Vec2i(284, 160), 2.F);
    state_.samples_per_pixel = 4;
    state_.passes = 1;
  }
  void add(Vec2i pixel, float value) {
    film_.add(0, 1, pixel, Spectrum(value));
    film_.add(1, 2, pixel, Spectrum(0.25F * value));
  }
  /// The last picture may take so many seconds of `patience`.
  std::unique_ptr<Preview> preview(int port, double patience = 60.0) {
    PreviewOptions options;
    options.viewer = {"127.0.0.1", std::to_string(port)};
    options.name = "room";
    options.film_scale = 2.0;
    options.aovs = {"samples"};
    options.every = 0.0;
    options.patience = patience;
    options.seconds_to_retry = 0.02;
    options.note = [this](const std::string& text) {
      const std::lock_guard lock(mutex_);
      notes_ += text + "\n";
    };
    return std::make_unique<Preview>(options, integrator_);
  }
  std::string notes() {
    const std::lock_guard lock(mutex_);
    return notes_;
  }
  /// Shows the film as it is, and waits until the viewer can have it.
  void show(Preview& preview) {
    ASSERT_TRUE(wait_until([&] { return preview.wants_picture(state_); })) << notes();
    preview.see_picture(film_, state_);
  }
  Picture expected() const { return develop(film_, integrator_, 4, 2.0, {"samples"}); }

  TestIntegrator integrator_;
  Film film_;
  JobState state_;
  std::mutex mutex_;
  std::string notes_;
};

TEST_F(PreviewTest, TheViewerHasEveryLayerOfThePicture) {
  FakeViewer viewer(Manners::Good);
  const auto sender = preview(viewer.port());
  show(*sender);
  ASSERT_TRUE(wait_until([&] { return sender->wants_picture(state_); }));
  const Picture wanted = expected();
  const std::vector<std::string> names = channel_names(wanted);
  EXPECT_EQ(names, (std::vector<std::string>{"R", "G", "B", "direct.R", "direct.G", "direct.B",
                                             "indirect.R", "indirect.G", "indirect.B", "samples"}));
  ASSERT_TRUE(wait_until([&] { return viewer.picture("room").updates == 6; }));
  const FakeViewer::Picture shown = viewer.picture("room");
  EXPECT_EQ(viewer.fault(), "");
  EXPECT_EQ(shown.width, kSize.x);
  EXPECT_EQ(shown.height, kSize.y);
  ASSERT_EQ(shown.channels.size(), names.size());
  std::size_t number = 0;
  for (const Picture::Layer& layer : wanted.layers) {
    for (int channel = 0; channel < layer.channels; ++channel, ++number) {
      const std::vector<float>& pixels = shown.channels.at(names[number]);
      for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
          const bool inside = kCrop.intersects(Vec2i(x, y));
          const int at = (y - kCrop.min.y) * (kCrop.size().x + 1) + x - kCrop.min.x;
          const int index = at * layer.channels + channel;
          const float value = inside ? layer.pixels[static_cast<std::size_t>(index)] : 0.F;
          ASSERT_EQ(pixels[shown.at(x, y)], value) << names[number] << " at " << x << ", " << y;
        }
      }
    }
  }
}

TEST_F(PreviewTest, OnlyRegionsThatChangedAreSentAgain) {
  FakeViewer viewer(Manners::Good);
  const auto sender = preview(viewer.port());
  show(*sender);
  ASSERT_TRUE(wait_until([&] { return viewer.picture("room").updates == 6; }));
  add(Vec2i(200, 20), 3.F);
  show(*sender);
  ASSERT_TRUE(wait_until([&] { return sender->wants_picture(state_); }));
  ASSERT_TRUE(wait_until([&] { return viewer.picture("room").updates == 7; }));
  const FakeViewer::Picture shown = viewer.picture("room");
  EXPECT_EQ(shown.creations, 1);
  EXPECT_GT(shown.channels.at("R")[20 * 300 + 200], 0.F);
}

TEST_F(PreviewTest, ShowsAPictureOfItsOwnBeforeThatOfTheFilm) {
  Picture look;
  look.resolution = kSize;
  look.crop = kCrop;
  look.layers.push_back({"", 3, std::vector<float>(3U * 280 * 158, 0.5F)});
  FakeViewer viewer(Manners::Good);
  const auto sender = preview(viewer.port());
  sender->show(look);
  ASSERT_TRUE(wait_until([&] { return viewer.picture("room").updates == 6; }));
  EXPECT_EQ(viewer.picture("room").channels.size(), 3U);
  EXPECT_EQ(viewer.picture("room").channels.at("G")[20 * 300 + 200], 0.5F);
  show(*sender);
  ASSERT_TRUE(wait_until([&] { return viewer.picture("room").channels.size() == 10; }));
  ASSERT_TRUE(wait_until([&] { return viewer.picture("room").updates == 12; }));
  EXPECT_EQ(viewer.picture("room").channels.at("G")[20 * 300 + 200], 0.F);
  EXPECT_EQ(viewer.fault(), "");
}

TEST_F(PreviewTest, NobodyIsAskedForAPictureWithoutAViewer) {
  std::unique_ptr<Preview> sender;
  int port = 0;
  {
    FakeViewer viewer(Manners::Good);
    port = viewer.port();
  }
  sender = preview(port);
  ASSERT_TRUE(wait_until([&] { return !notes().empty(); }));
  EXPECT_NE(notes().find("it will be tried again"), std::string::npos) << notes();
  EXPECT_FALSE(sender->wants_picture(state_));
  // A viewer that comes later has the whole picture.
  FakeViewer viewer(Manners::Good, port);
  show(*sender);
  EXPECT_TRUE(wait_until([&] { return viewer.picture("room").updates == 6; })) << notes();
}

TEST_F(PreviewTest, AViewerThatDoesNotReadIsNotWaitedFor) {
  FakeViewer viewer(Manners::Silent);
  auto sender = preview(viewer.port(), 1.0);
  ASSERT_TRUE(wait_until([&] { return sender->wants_picture(state_); }));
  // Until what the system keeps for the viewer is full, which is a few of these pictures. On a busy
  // machine half a second may be over before that; then less is tested, but nothing fails.
  constexpr int kFarTooMany = 200;
  int pictures = 0;
  for (; pictures < kFarTooMany; ++pictures) {
    bool taken = false;
    for (int wait = 0; wait < 100 && !taken; ++wait) {
      taken = sender->wants_picture(state_);
      if (!taken) std::this_thread::sleep_for(5ms);
    }
    if (!taken) break;
    for (int x = 10; x < 280; x += 100) add(Vec2i(x, 20 + pictures % 100), 1.F);
    sender->see_picture(film_, state_);
  }
  EXPECT_LT(pictures, kFarTooMany) << "pictures pile up";
  const Stopwatch clock;
  sender->see_picture(film_, state_);  // nothing, at once
  sender->show_last(film_, state_);    // within its patience
  sender.reset();
  // Generous: the machine may be busy.
  EXPECT_LT(clock.seconds(), 10.0);
}

TEST_F(PreviewTest, ViewersThatCloseOrBabbleDoNoHarm) {
  int port = 0;
  std::unique_ptr<Preview> sender;
  {
    FakeViewer rude(Manners::Rude);
    port = rude.port();
    sender = preview(port);
    for (int i = 0; i < 3; ++i) {
      show(*sender);
      ASSERT_TRUE(wait_until([&] { return rude.connections() > i + 1; })) << i;
    }
  }
  FakeViewer babbling(Manners::Babbling, port);
  // Sends like a render, again and again. The first may go to the connection that is lost.
  EXPECT_TRUE(wait_until([&] {
    sender->see_picture(film_, state_);
    return babbling.picture("room").updates >= 6;
  }));
  EXPECT_EQ(babbling.fault(), "");
}

TEST_F(PreviewTest, TheLastPictureIsShown) {
  FakeViewer viewer(Manners::Good);
  auto sender = preview(viewer.port());
  show(*sender);
  add(Vec2i(100, 100), 7.F);
  sender->show_last(film_, state_);
  sender.reset();
  EXPECT_TRUE(wait_until([&] {
    const FakeViewer::Picture shown = viewer.picture("room");
    // The viewer may not have read yet that there is a picture.
    return shown.creations == 1 && shown.channels.at("R").at(shown.at(100, 100)) > 0.F;
  }));
}

TEST_F(PreviewTest, TheRenderKeepsItsBits) {
  const auto render = [](std::vector<PassObserver*> observers) {
    const Vec2i size(40, 30);
    TestIntegrator integrator(size, kReplicates);
    Film film(size, Box2i(Vec2i(0, 0), size - Vec2i(1, 1)), Filter::box(), kReplicates,
              integrator.layers());
    RenderJobOptions options;
    options.budget.samples_per_pixel = 8;
    options.threads = 2;
    options.pass_seconds = 0.0;
    options.observers = std::move(observers);
    RenderJob(integrator, film, options).run();
    return std::vector<std::int64_t>(film.raw().begin(), film.raw().end());
  };
  FakeViewer viewer(Manners::Good);
  const auto sender = preview(viewer.port());
  ASSERT_TRUE(wait_until([&] { return sender->wants_picture(state_); }));
  EXPECT_EQ(render({sender.get()}), render({}));
  EXPECT_TRUE(wait_until([&] { return viewer.picture("room").updates > 0; }));
}

TEST(Viewer, IsAHostAndAPort) {
  const auto is = [](const char* text, const char* host, const char* port) {
    const ViewerAddress viewer = parse_viewer("--preview", text);
    EXPECT_EQ(viewer.host, host) << text;
    EXPECT_EQ(viewer.port, port) << text;
  };
  is("localhost:14158", "localhost", "14158");
  is("render-farm", "render-farm", "14158");
  is("[::1]:5000", "::1", "5000");
  is("[::1]", "::1", "14158");
  for (const char* text : {"", ":", ":14158", "host:", "host:0", "host:65536", "host:x", "::1:80",
                           "[::1", "[::1]5000", "[::1]:"}) {
    EXPECT_THROW(parse_viewer("--preview", text), UsageError) << text;
  }
  EXPECT_THROW(find_addresses("--preview", {"no host has spaces", "1"}), UsageError);
}

}  // namespace
}  // namespace ajar
