// Renders that are stopped and go on, or are shared by several processes, end with the same bits.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "core/archive.h"
#include "image/make_filter.h"
#include "session/checkpoint.h"
#include "session/preparation.h"
#include "session/render_job.h"
#include "session/testing/thread_ranks.h"
#include "session/version.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar {
namespace {

constexpr std::uint64_t kSamples = 8;

using Sums = std::vector<std::int64_t>;

/// A method on a scene, as `ajar render` would make it.
class Case {
 public:
  Case(const Scene& scene, const IntegratorInfo& info) : scene_(scene), info_(info) {
    settings_.resolution = scene.camera().resolution();
    settings_.crop = Box2i(Vec2i(0, 0), settings_.resolution - Vec2i(1, 1));
    settings_.max_depth = 6;
    settings_.seed = 7;
    settings_.aovs = {"albedo", "object-id"};
    // The default bootstrap takes longer than all the rest.
    for (const ParameterSpec& spec : info.parameters) {
      if (spec.name == "bootstrap") parameters_["bootstrap"] = "3000";
    }
  }

  std::unique_ptr<Integrator> make() const {
    auto integrator = info_.make(scene_, settings_, Parameters(info_.parameters, parameters_));
    prepare(*integrator);
    return integrator;
  }
  Film film(const Integrator& integrator) const {
    return {settings_.resolution, settings_.crop, make_filter(scene_.film().filter),
            settings_.replicates, integrator.layers()};
  }
  static RenderJobOptions options(int threads) {
    RenderJobOptions options;
    options.budget.samples_per_pixel = kSamples;
    options.threads = threads;
    return options;
  }
  Sums left_alone() const {
    const auto integrator = make();
    Film whole = film(*integrator);
    RenderJob(*integrator, whole, options(2)).run();
    return {whole.raw().begin(), whole.raw().end()};
  }

  const Scene& scene_;
  const IntegratorInfo& info_;
  RenderSettings settings_;
  std::map<std::string, std::string> parameters_;
};

class Resume : public ::testing::TestWithParam<test::SmallScene> {
 protected:
  Resume() : scene_(test::scene_from(GetParam().text)) {}
  std::vector<Case> cases() const {
    std::vector<Case> cases;
    for (const IntegratorInfo& info : integrators()) {
      Case one(*scene_, info);
      if (one.make()->can_save_state()) cases.push_back(std::move(one));
    }
    return cases;
  }
  std::unique_ptr<Scene> scene_;
};

/// One pass, from the checkpoint in a file to the next; on the first pass there is none.
void run_one_pass(const Case& one, const std::string& path, bool first, int threads) {
  const auto integrator = one.make();
  Film film = one.film(*integrator);
  RenderJobOptions options = Case::options(threads);
  if (!first) {
    Checkpoint read = read_checkpoint(path);
    check_scene(read, one.scene_.hash(), integrator->layers(), path, false);
    unarchive(read.integrator_state,
              [&](InputArchive& archive) { integrator->load_state(archive); });
    options.resumed = read.job;
    film = film_of(read, film.filter(), path);
  }
  options.pass_seconds = 0.0;
  class StopAfterPass final : public PassObserver {
   public:
    explicit StopAfterPass(std::uint64_t passes) : passes_(passes) {}
    bool wants_picture(const JobState& state) override {
      if (state.passes > passes_) interrupts = 1;
      return false;
    }
    void see_picture(const Film& /*film*/, const JobState& /*state*/) override {}
    InterruptCount interrupts{0};

   private:
    std::uint64_t passes_;
  };
  StopAfterPass stop(options.resumed ? options.resumed->passes : 0);
  options.interrupts = &stop.interrupts;
  options.observers = {&stop};
  RenderJob job(*integrator, film, options);
  job.run();
  Checkpoint next;
  next.version = version();
  next.render.scene_hash = one.scene_.hash();
  next.render.settings = one.settings_;
  next.layers.assign(film.layers().begin(), film.layers().end());
  next.job = job.state();
  next.integrator_state =
      archived([&](OutputArchive& archive) { integrator->save_state(archive); });
  write_checkpoint(path, next, film.raw());
}

TEST_P(Resume, AtEveryPassGivesTheSameBits) {
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("ajar-resume-" + GetParam().name + std::to_string(getpid())))
                               .string();
  for (const Case& one : cases()) {
    int passes = 0;
    Checkpoint last;
    do {
      constexpr int kThreads[] = {1, 2, 5};
      run_one_pass(one, path, passes == 0, kThreads[passes % 3]);
      ++passes;
      last = read_checkpoint(path);
    } while (last.job.samples_per_pixel < kSamples && passes < 100);
    EXPECT_GE(passes, 3) << one.info_.name;
    EXPECT_EQ(last.sums, one.left_alone()) << one.info_.name;
  }
  std::filesystem::remove(path);
}

TEST_P(Resume, OnSeveralRanksGivesTheSameBits) {
  for (const Case& one : cases()) {
    if (one.make()->keeps_state()) continue;
    const Sums alone = one.left_alone();
    for (const int count : {1, 2, 3}) {
      ThreadRanks ranks(count);
      Sums together;
      std::vector<std::thread> threads;
      for (int rank = 0; rank < count; ++rank) {
        threads.emplace_back([&, rank] {
          const auto integrator = one.make();
          Film film = one.film(*integrator);
          RenderJobOptions options = Case::options(1);
          options.ranks = &ranks.member(rank);
          RenderJob job(*integrator, film, options);
          job.run();
          if (rank == 0) together.assign(job.film().raw().begin(), job.film().raw().end());
        });
      }
      for (std::thread& thread : threads) thread.join();
      EXPECT_EQ(together, alone) << one.info_.name << ", " << count << " ranks";
    }
  }
}

/// Those that differ in what the film or the sampler does.
std::vector<test::SmallScene> different_scenes() {
  std::vector<test::SmallScene> scenes = test::small_scenes();
  std::erase_if(scenes, [](const test::SmallScene& scene) {
    return scene.name != "Room" && scene.name != "RoughGlass" && scene.name != "Environment" &&
           scene.name != "CroppedMitchell" && scene.name != "Fog";
  });
  return scenes;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Resume, ::testing::ValuesIn(different_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace ajar
