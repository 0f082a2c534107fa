// Kill −9 at a hundred random times loses nothing. The renders are forks of the test, so that most
// of their short lives are spent rendering and writing.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <thread>

#include "core/archive.h"
#include "session/checkpoint/checkpoint_writer.h"
#include "session/job/preparation.h"
#include "session/job/render_job.h"
#include "session/render/resolved_render.h"
#include "session/version.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

constexpr int kKills = 100;
constexpr std::uint64_t kSamples = 6000;

/// Begins or goes on, and writes a checkpoint after every pass.
void render_with_checkpoints(const Scene& scene, const std::string& integrator_name,
                             const std::string& path) {
  const IntegratorInfo& info = find_integrator(integrator_name);
  RenderSettings settings;
  settings.resolution = {10, 6};
  settings.crop = Box2i(Vec2i(0, 0), Vec2i(9, 5));
  settings.max_depth = 4;
  std::map<std::string, std::string> parameters;
  // The default bootstrap takes longer than a render lives.
  if (integrator_name.ends_with("mlt")) parameters["bootstrap"] = "2000";
  const auto integrator = info.make(scene, settings, info.read(parameters));
  prepare(*integrator);
  Film film = film_for(scene, settings, *integrator);
  RenderJobOptions options;
  options.budget.samples_per_pixel = kSamples;
  options.threads = 1;
  options.pass_seconds = 0.0005;
  Checkpoint base;
  base.version = version();
  base.render.settings = settings;
  base.render.integrator = integrator_name;
  base.render.scene_hash = scene.hash();
  base.layers.assign(film.layers().begin(), film.layers().end());
  if (fs::exists(path)) {
    Checkpoint read = read_checkpoint(path);
    check_scene(read, scene.hash(), integrator->layers(), path, false);
    unarchive(read.integrator_state, [&](InputArchive& archive) {
      integrator->load_state(archive, read.job.samples_per_pixel);
    });
    options.resumed = read.job;
    base.resumptions = read.resumptions + 1;
    film = film_of(read, film.filter(), path);
  }
  CheckpointWriter writer(
      path, 0.0, base, *integrator, [](const std::string&) {}, [](const std::string&) {});
  options.observers = {&writer};
  RenderJob job(*integrator, film, options);
  job.run();
  const std::vector<FinalFile> last = {writer.last(job.film(), job.state(), false)};
  if (!write_final_files(last, nullptr).front().error.empty()) _exit(1);
}

class Soak : public ::testing::TestWithParam<const char*> {};

TEST_P(Soak, KilledAHundredTimesARenderEndsWithTheSameBits) {
  const fs::path folder = fs::temp_directory_path() / ("ajar-soak-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const auto scene = test::scene_from(test::small_scenes().front().text);
  const auto start = [&](const std::string& name) {
    const pid_t child = fork();
    if (child == 0) {
      try {
        render_with_checkpoints(*scene, GetParam(), (folder / name).string());
      } catch (const std::exception& error) {
        fprintf(stderr, "%s\n", error.what());
        _exit(2);
      }
      _exit(0);
    }
    return child;
  };
  const auto finish = [](pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  };
  ASSERT_EQ(finish(start("alone")), 0);
  const Checkpoint alone = read_checkpoint((folder / "alone").string());
  const auto expect_same = [&] {
    const Checkpoint soaked = read_checkpoint((folder / "soak").string());
    EXPECT_EQ(soaked.sums, alone.sums);
    // Not the rays: chains that are started more often trace more.
    EXPECT_EQ(soaked.job.counters.samples, alone.job.counters.samples);
    EXPECT_EQ(soaked.job.counters.mutations, alone.job.counters.mutations);
    EXPECT_EQ(soaked.job.samples_per_pixel, alone.job.samples_per_pixel);
  };

  std::mt19937 random(5);
  // Longest life of a render: longer after each that made no progress, without a limit, since
  // machines may be slow or busy. Six of ten get somewhere then, wherever they run: 0.6 ln(7/8) +
  // 0.4 ln(10/8) = 0. Nor is a whole render ever waited for in vain: one that ends by itself got
  // somewhere.
  std::uint32_t microseconds = 30000;
  int progressed = 0;
  std::uint64_t samples = 0;
  for (int killed = 0; killed < kKills;) {
    const pid_t child = start("soak");
    std::this_thread::sleep_for(std::chrono::microseconds(random() % microseconds));
    kill(child, SIGKILL);
    const int status = finish(child);
    ASSERT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0) << "kill " << killed;
    std::uint64_t now = 0;
    if (fs::exists(folder / "soak")) {
      now = read_checkpoint((folder / "soak").string()).job.samples_per_pixel;
    }
    ASSERT_GE(now, samples) << "nothing is lost";
    progressed += now > samples ? 1 : 0;
    microseconds = microseconds / 8 * (now > samples ? 7 : 10);
    samples = now;
    if (WIFSIGNALED(status)) {
      ++killed;
    } else {
      // The render finished: once more, from the beginning.
      expect_same();
      fs::remove(folder / "soak");
      samples = 0;
    }
  }
  EXPECT_GT(progressed, kKills / 4)
      << "most were killed before they wrote a checkpoint: the test proves little";
  ASSERT_EQ(finish(start("soak")), 0);
  expect_same();
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2) << "no parts are left behind";
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Methods, Soak, ::testing::Values("pt", "selective"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace ajar
