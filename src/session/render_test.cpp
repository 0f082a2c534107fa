#include "session/render.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <future>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/error.h"
#include "core/testing/wait_until.h"
#include "import/pbrt/pbrt_import.h"
#include "session/scenes/scene_file.h"
#include "session/testing/fake_viewer.h"
#include "session/testing/thread_ranks.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

RenderRequest small_request(std::optional<std::uint64_t> samples = 8) {
  RenderRequest request;
  request.scene = "builtin:cornell";
  RenderSpec& spec = request.spec;
  spec.integrator = "pt";
  spec.resolution = {24, 18};
  spec.samples_per_pixel = samples;
  // A day, which no test waits for.
  if (!samples) spec.seconds = 86400.0;
  return request;
}

const std::vector<float>& pixels_of(const Picture& picture) {
  return picture.layers.front().pixels;
}

std::uint64_t samples_of(const Picture& picture) {
  return std::stoull(picture.metadata.at("ajar:samples_per_pixel"));
}

std::shared_ptr<LoadedScene> loaded(const std::string& scene) {
  Warnings warnings;
  return std::make_shared<LoadedScene>(load_scene(scene, warnings));
}

std::vector<float> rendered(RenderRequest request) {
  Render render(std::move(request));
  return pixels_of(*render.run().picture);
}

/// Keeps what it is told; more is done in a pass if a test wants it.
struct Listener final : RenderEvents {
  std::vector<std::string> phases;
  int passes = 0;
  int pictures = 0;
  int finishes = 0;
  std::vector<std::string> notes;
  std::mutex mutex;
  bool at_work = false;
  std::function<void(const RenderSnapshot&)> on_progress;
  std::atomic<bool> has_passes{false};

  std::function<void(RenderPhase)> on_phase;
  std::function<void()> on_picture;
  std::function<void()> on_note;

  void phase_begun(RenderPhase phase) override {
    phases.emplace_back(to_string(phase));
    if (on_phase) on_phase(phase);
  }
  void work_begun(const std::function<RenderSnapshot()>&) override { at_work = true; }
  void work_ended() noexcept override { at_work = false; }
  void progress(const RenderSnapshot& snapshot) override {
    EXPECT_TRUE(at_work);
    ++passes;
    if (snapshot.samples_done >= 4.0) has_passes = true;
    if (on_progress) on_progress(snapshot);
  }
  void picture(const Picture& picture) override {
    EXPECT_FALSE(picture.layers.empty());
    ++pictures;
    if (on_picture) on_picture();
  }
  void note(const std::string& text) override {
    const std::lock_guard lock(mutex);  // notes of a viewer come from its thread
    notes.push_back(text);
    if (on_note) on_note();
  }
  void finished(const RenderOutcome&) override { ++finishes; }
};

TEST(Render, TellsItsStepsAndItsEnd) {
  Listener listener;
  Render render(small_request(), listener);
  const RenderOutcome& outcome = render.run();
  EXPECT_EQ(listener.phases,
            (std::vector<std::string>{"load", "build", "prepare", "render", "write"}));
  EXPECT_GT(listener.passes, 1);
  EXPECT_EQ(listener.pictures, 0);
  EXPECT_EQ(listener.finishes, 1);
  EXPECT_FALSE(outcome.interrupted);
  ASSERT_TRUE(outcome.picture);
  EXPECT_EQ(outcome.picture->metadata.at("ajar:samples_per_pixel"), "8");
  EXPECT_EQ(outcome.statistics.result.samples_per_pixel, 8U);
  EXPECT_TRUE(outcome.files.empty());
  EXPECT_EQ(render.picture(), outcome.picture);
  EXPECT_EQ(render.statistics().result.samples_per_pixel, 8U);
  EXPECT_EQ(render.snapshot().samples_done, 8.0);
}

TEST(Render, TakesASceneThatIsReady) {
  RenderRequest request = small_request();
  request.loaded = loaded(request.scene);
  Listener listener;
  Render render(std::move(request), listener);
  EXPECT_EQ(pixels_of(*render.run().picture), rendered(small_request()));
  EXPECT_EQ(listener.phases.front(), "build");
}

TEST(Render, TakesASceneThatWasBuiltForAnother) {
  const std::shared_ptr<LoadedScene> scene = loaded("builtin:cornell");
  RenderSpec spec = small_request().spec;
  const auto first_phase = [&] {
    RenderRequest request = small_request();
    request.spec = spec;
    RenderRequest alone = small_request();
    alone.spec = spec;
    request.loaded = scene;
    Listener listener;
    Render render(std::move(request), listener);
    EXPECT_EQ(pixels_of(*render.run().picture), rendered(std::move(alone)));
    return listener.phases.front();
  };
  EXPECT_EQ(first_phase(), "build");
  EXPECT_EQ(first_phase(), "prepare");
  spec.integrator = "mmlt";
  spec.seed = 7;
  EXPECT_EQ(first_phase(), "prepare");
  spec.crop = {3, 2, 20, 15};
  EXPECT_EQ(first_phase(), "prepare");
  spec.resolution = {30, 18};
  EXPECT_EQ(first_phase(), "build");
  spec.filter = "gaussian";
  EXPECT_EQ(first_phase(), "build");
  EXPECT_EQ(first_phase(), "prepare");
  spec = small_request().spec;
  EXPECT_EQ(first_phase(), "build") << "one is kept";
}

/// A texture is missing, which is found when the scene is built.
TEST(Render, TellsTheWarningsOfASceneThatWasBuiltForAnother) {
  Warnings warnings;
  const auto scene = std::make_shared<LoadedScene>(import_pbrt_text(
      R"(Film "image" "integer xresolution" 8 "integer yresolution" 8
         WorldBegin
         LightSource "infinite"
         Texture "missing" "color" "imagemap" "string filename" "none.png"
         Material "matte" "texture Kd" "missing"
         Shape "sphere"
         WorldEnd)",
      "test.pbrt", ".", warnings));
  std::vector<std::vector<std::string>> told;
  for (int i = 0; i < 2; ++i) {
    RenderRequest request;
    request.scene = "test.pbrt";
    request.loaded = scene;
    request.spec.integrator = "pt";
    request.spec.samples_per_pixel = 4;
    Render render(std::move(request));
    told.push_back(render.run().statistics.warnings);
  }
  EXPECT_NE(told[0].back().find("none.png"), std::string::npos);
  EXPECT_EQ(told[1], told[0]);
}

TEST(Render, IsStoppedByAnotherThread) {
  Listener listener;
  Render render(small_request(std::nullopt), listener);
  std::thread user([&] {
    listener.has_passes.wait(false);
    render.stop();
  });
  listener.on_progress = [&](const RenderSnapshot&) { listener.has_passes.notify_all(); };
  const RenderOutcome& outcome = render.run();
  user.join();
  EXPECT_TRUE(outcome.interrupted);
  ASSERT_TRUE(outcome.picture);
  EXPECT_GE(outcome.statistics.result.samples_per_pixel, 4U);
}

TEST(Render, CountsOnTheCounterItIsGiven) {
  InterruptCount count{0};
  RenderRequest request = small_request(std::nullopt);
  request.interrupts = &count;
  Listener listener;
  listener.on_progress = [&](const RenderSnapshot&) { count = 1; };
  Render render(std::move(request), listener);
  EXPECT_TRUE(render.run().interrupted);
  render.stop();
  EXPECT_EQ(count, 2);
}

// Pictures between two passes are of so many samples, to the bit.
TEST(Render, ShowsItsPictureToOtherThreads) {
  Listener listener;
  Render render(small_request(std::nullopt), listener);
  listener.on_progress = [&](const RenderSnapshot&) { listener.has_passes.notify_all(); };
  std::shared_ptr<const Picture> seen;
  RenderStatistics known;
  std::thread viewer([&] {
    listener.has_passes.wait(false);
    known = render.statistics();
    // Where all replicates have the same number of samples, as in a render of so many.
    do {
      seen = render.picture();
    } while (samples_of(*seen) % ResolvedRender::kReplicates != 0);
    render.stop();
  });
  render.run();
  viewer.join();
  ASSERT_TRUE(seen);
  EXPECT_EQ(known.result.stopped_by, StopReason::NotYet);
  EXPECT_GE(known.result.samples_per_pixel, 4U);
  EXPECT_LE(known.result.samples_per_pixel, samples_of(*seen));
  EXPECT_GT(known.result.counters.rays, 0U);
  EXPECT_EQ(known.render.integrator, "pt");
  EXPECT_EQ(pixels_of(*seen), rendered(small_request(samples_of(*seen))));
}

TEST(Render, HasNoPictureBeforeItsFirstPass) {
  Listener listener;
  Render render(small_request(), listener);
  EXPECT_FALSE(render.picture());
  EXPECT_EQ(render.statistics().render.scene, "builtin:cornell");
  // On its own thread, which would wait for itself.
  listener.on_progress = [&](const RenderSnapshot&) { EXPECT_FALSE(render.picture()); };
  EXPECT_TRUE(render.run().picture);
}

/// A preparation of eight samples per pixel, or one that is far too long for these.
RenderRequest selective_request(bool prepared = true) {
  RenderRequest request = small_request();
  request.spec.integrator = "selective";
  request.spec.max_depth = 3;
  if (!prepared) {
    request.spec.parameters = {{"pilot", "discard"}};
    request.spec.resolution = {240, 180};
  }
  return request;
}

bool has_note(const Listener& listener, const std::string& part) {
  return std::any_of(listener.notes.begin(), listener.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

constexpr const char* kFewSamples = "too few samples to look for difficult light";

TEST(Render, OfFewSamplesDoesWithoutALongPreparation) {
  std::vector<std::vector<float>> pictures;
  for (const int threads : {1, 2}) {
    RenderRequest request = selective_request(false);
    request.spec.threads = threads;
    Listener listener;
    Render render(std::move(request), listener);
    const RenderOutcome& outcome = render.run();
    EXPECT_TRUE(has_note(listener, kFewSamples));
    EXPECT_FALSE(outcome.statistics.prepared);
    EXPECT_EQ(outcome.picture->metadata.at("ajar:prepared"), "false");
    EXPECT_EQ(outcome.statistics.preparation.rays, 0U);
    pictures.push_back(pixels_of(*outcome.picture));
  }
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST(Render, OfFewSamplesIsPreparedIfThatIsShort) {
  Listener listener;
  Render render(selective_request(), listener);
  const RenderOutcome& outcome = render.run();
  EXPECT_TRUE(outcome.statistics.prepared);
  EXPECT_EQ(outcome.picture->metadata.at("ajar:prepared"), "true");
  EXPECT_FALSE(has_note(listener, kFewSamples));
}

/// A render of enough camera samples.
TEST(Render, HasTheChainsThatWereAskedForByName) {
  RenderRequest request = small_request(1);
  request.spec.integrator = "mmlt";
  request.spec.parameters = {{"bootstrap", "200000"}};
  request.spec.max_depth = 3;
  Listener listener;
  Render render(std::move(request), listener);
  EXPECT_TRUE(render.run().statistics.prepared);
  EXPECT_TRUE(has_note(listener, "Markov chains make all light"));
}

TEST(Render, ShowsWhatItsPreparationHasSeen) {
  RenderRequest request = selective_request();
  request.show_every = 1e3;
  FakeViewer viewer(FakeViewer::Manners::Good);
  request.spec.preview = "127.0.0.1:" + std::to_string(viewer.port());
  Listener listener;
  Render render(std::move(request), listener);
  std::shared_ptr<const Picture> look;
  listener.on_phase = [&](RenderPhase phase) {
    if (phase != RenderPhase::Render) return;
    EXPECT_EQ(listener.pictures, 1);
    look = render.picture();
    EXPECT_TRUE(wait_until([&] { return viewer.picture("ajar: cornell").updates == 1; }));
    EXPECT_EQ(viewer.picture("ajar: cornell").channels.size(), 3U);
  };
  const RenderOutcome& outcome = render.run();
  ASSERT_TRUE(look);
  EXPECT_EQ(samples_of(*look), 0U);
  EXPECT_EQ(look->layers.size(), 1U);
  const std::vector<float>& final = pixels_of(*outcome.picture);
  ASSERT_EQ(pixels_of(*look).size(), final.size());
  const auto mean = [](const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  EXPECT_NEAR(mean(pixels_of(*look)), mean(final), 0.3 * mean(final));
  EXPECT_EQ(final, rendered(selective_request())) << "who looks changes nothing";
  EXPECT_EQ(render.picture(), outcome.picture);
  EXPECT_EQ(viewer.fault(), "");
}

TEST(Render, HasNoPictureIfItEndsWithWhatItsPreparationHasSeen) {
  RenderRequest request = selective_request();
  request.show_every = 1e3;
  Listener listener;
  Render render(std::move(request), listener);
  listener.on_picture = [&] {
    render.stop();
    render.stop();
  };
  EXPECT_FALSE(render.run().picture);
  EXPECT_EQ(listener.pictures, 1);
  EXPECT_FALSE(render.picture());
}

/// A resumed render has had better pictures.
TEST(Render, DoesNotShowWhatItsPreparationSeesAgain) {
  const std::string checkpoint =
      (std::filesystem::temp_directory_path() / ("ajar-look-" + std::to_string(::getpid())))
          .string();
  RenderRequest request = selective_request();
  request.spec.checkpoint = checkpoint;
  Render(std::move(request)).run();
  RenderRequest on;
  on.spec.samples_per_pixel = 16;
  on.show_every = 1e3;
  resume_from(checkpoint, on);
  Listener listener;
  Render render(std::move(on), listener);
  std::shared_ptr<const Picture> look;
  listener.on_phase = [&](RenderPhase phase) {
    if (phase == RenderPhase::Render) look = render.picture();
  };
  EXPECT_TRUE(render.run().picture);
  EXPECT_FALSE(look);
  EXPECT_EQ(listener.pictures, 0);
  std::filesystem::remove(checkpoint);
}

TEST(Render, HasNoPictureIfItFailsAfterItsPreparation) {
  Listener listener;
  listener.on_note = [] { throw std::runtime_error("enough"); };
  Render render(selective_request(), listener);
  EXPECT_THROW(render.run(), std::runtime_error);
  EXPECT_FALSE(render.picture());
}

TEST(Render, ShowsPicturesToItsListener) {
  RenderRequest request = small_request(64);
  request.show_every = 0.0;
  Listener listener;
  Render render(std::move(request), listener);
  render.run();
  EXPECT_GT(listener.pictures, 0);
}

TEST(Render, IsStoppedBeforeItBegins) {
  Listener listener;
  Render render(small_request(), listener);
  render.stop();
  render.stop();
  // Path tracing has nothing to prepare that could be cut short.
  EXPECT_TRUE(render.run().picture);
  RenderRequest request = small_request();
  request.spec.integrator = "mmlt";
  Render chains(std::move(request), listener);
  chains.stop();
  chains.stop();
  const RenderOutcome& outcome = chains.run();
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_FALSE(outcome.picture);
  EXPECT_NE(listener.notes.back().find("nothing was rendered"), std::string::npos);
}

TEST(Render, LeavesNobodyWaitingWhenItFails) {
  Listener listener;
  Render render(small_request(std::nullopt), listener);
  std::future<std::shared_ptr<const Picture>> asked;
  listener.on_progress = [&](const RenderSnapshot& snapshot) {
    if (snapshot.samples_done < 4.0) return;
    if (asked.valid()) throw std::runtime_error("enough");
    // Waits for the next pass, or for the end that comes before it.
    asked = std::async(std::launch::async, [&render] { return render.picture(); });
  };
  EXPECT_THROW(render.run(), std::runtime_error);
  EXPECT_FALSE(listener.at_work);
  ASSERT_TRUE(asked.valid());
  asked.wait();
  EXPECT_FALSE(render.picture());
  EXPECT_GT(render.snapshot().samples_done, 0.0);
}

TEST(Render, RefusesBeforeItLoads) {
  RenderRequest request = small_request();
  request.scene = "builtin:no-such-scene";
  request.spec.tone_map = "no-such-curve";
  EXPECT_THROW(Render{std::move(request)}, UsageError);
  RenderRequest unknown = small_request();
  unknown.scene = "builtin:no-such-scene";
  Render render(std::move(unknown));
  EXPECT_THROW(render.run(), UsageError);
}

TEST(Render, MayRunBesideAnother) {
  const std::vector<float> alone = rendered(small_request());
  auto other = std::async(std::launch::async, [] { return rendered(small_request()); });
  EXPECT_EQ(rendered(small_request()), alone);
  EXPECT_EQ(other.get(), alone);
}

TEST(Render, IsOneOfSeveralRanks) {
  constexpr int kRanks = 3;
  ThreadRanks ranks(kRanks);
  std::vector<std::shared_ptr<const Picture>> pictures(kRanks);
  std::vector<std::thread> threads;
  threads.reserve(kRanks);
  for (int rank = 0; rank < kRanks; ++rank) {
    threads.emplace_back([&, rank] {
      RenderRequest request = small_request();
      request.ranks = &ranks.member(rank);
      Render render(std::move(request));
      const RenderOutcome& outcome = render.run();
      EXPECT_EQ(outcome.statistics.ranks, kRanks);
      EXPECT_EQ(outcome.picture, render.picture());
      pictures[static_cast<std::size_t>(rank)] = outcome.picture;
    });
  }
  for (std::thread& thread : threads) thread.join();
  ASSERT_TRUE(pictures[0]);
  EXPECT_FALSE(pictures[1]);
  EXPECT_FALSE(pictures[2]);
  EXPECT_EQ(pixels_of(*pictures[0]), rendered(small_request()));
}

TEST(Render, WritesFilesAndGoesOn) {
  const fs::path folder =
      fs::temp_directory_path() / ("ajar-render-test-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const std::string checkpoint = (folder / "half.ckpt").string();
  RenderRequest request = small_request(8);
  request.spec.outputs = {(folder / "half.exr").string()};
  request.spec.statistics = (folder / "half.json").string();
  request.spec.checkpoint = checkpoint;
  lock_checkpoint_of(request);
  {
    Render render(std::move(request));
    const RenderOutcome& outcome = render.run();
    EXPECT_TRUE(outcome.all_written());
    EXPECT_EQ(outcome.files.size(), 2U);
    EXPECT_EQ(outcome.statistics.outputs, std::vector<std::string>{(folder / "half.exr").string()});
  }
  EXPECT_TRUE(fs::exists(folder / "half.exr"));
  EXPECT_TRUE(fs::exists(folder / "half.json"));
  RenderRequest second;
  second.spec.samples_per_pixel = 16;
  resume_from(checkpoint, second);
  EXPECT_EQ(second.scene, "builtin:cornell");
  EXPECT_EQ(rendered(std::move(second)), rendered(small_request(16)));

  // With more samples there would be enough for the preparation; but it was begun without.
  const std::string of_few = (folder / "few.ckpt").string();
  RenderRequest few = selective_request(false);
  few.spec.checkpoint = of_few;
  lock_checkpoint_of(few);
  rendered(std::move(few));
  RenderRequest whole = selective_request(false);
  whole.spec.samples_per_pixel = 12;
  const std::vector<float> expected = rendered(std::move(whole));
  for (const std::uint64_t samples : {12, 64}) {
    RenderRequest more;
    more.spec.samples_per_pixel = samples;
    resume_from(of_few, more);
    Listener listener;
    Render render(std::move(more), listener);
    const RenderOutcome& outcome = render.run();
    if (samples == 12) {
      EXPECT_EQ(pixels_of(*outcome.picture), expected);
    }
    EXPECT_TRUE(has_note(listener, kFewSamples));
    EXPECT_FALSE(outcome.statistics.prepared);
  }
  Listener listener;
  RenderRequest enough = selective_request(false);
  enough.spec.samples_per_pixel = 64;
  Render render(std::move(enough), listener);
  EXPECT_TRUE(render.run().statistics.prepared) << "what was not to be gone back on";
  fs::remove_all(folder);
}

}  // namespace
}  // namespace ajar
