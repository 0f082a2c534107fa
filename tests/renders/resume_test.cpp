// Renders that are stopped and go on, or are shared by several processes, end with the same bits.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "core/archive.h"
#include "session/checkpoint/checkpoint.h"
#include "session/job/preparation.h"
#include "session/job/render_job.h"
#include "session/render/resolved_render.h"
#include "session/testing/thread_ranks.h"
#include "session/version.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar {
namespace {

using Sums = std::vector<std::int64_t>;

/// An integrator and its parameters that are not at their defaults.
struct Method {
  std::string integrator;
  std::map<std::string, std::string> parameters;
  std::vector<std::string> aovs = {"albedo", "object-id"};
  /// seeds join chains and maps end epochs at 4, 8, …
  std::uint64_t samples = 16;
};

/// Every integrator, and the state of other chains, and of methods that adapt to their samples.
std::vector<Method> methods() {
  std::vector<Method> methods;
  for (const IntegratorInfo& info : integrators()) methods.push_back({info.name, {}});
  methods.push_back({"ibpt", {{"roulette", "efficient"}}, {}, 32});
  methods.push_back({"mmlt", {{"multi-try", "2"}}});
  methods.push_back({"mmlt", {{"step", "adaptive"}, {"m1", "1"}}});
  methods.push_back({"mmlt", {{"mutation", "fusion"}, {"rule", "published"}, {"m1", "1"}}});
  methods.push_back({"masked", {{"pilot", "keep"}, {"chain", "pssmlt"}}});
  methods.push_back({"masked", {{"chain", "erpt"}, {"mutations", "3"}}});
  methods.push_back({"selective", {{"chain", "mlt"}, {"split", "0.1"}}, {"density"}});
  // Without layers that want as many camera samples everywhere; and until more than three stretches
  // tell how much of the chains' error lasts.
  methods.push_back({"selective", {}, {"density"}});
  methods.push_back({"selective", {{"split", "0.1"}}, {"density"}, 32});
  return methods;
}

std::string text_of(const Method& method) {
  std::string text = method.integrator;
  for (const auto& [name, value] : method.parameters) {
    text.append(" ").append(name).append("=").append(value);
  }
  return text;
}

/// A method on a scene, as `ajar render` would make it.
class Case {
 public:
  Case(const Scene& scene, const Method& method)
      : scene_(scene),
        info_(find_integrator(method.integrator)),
        name_(text_of(method)),
        parameters_(method.parameters),
        samples_(method.samples) {
    settings_ = settings_for(scene);
    settings_.max_depth = 6;
    settings_.seed = 7;
    settings_.aovs = method.aovs;
    // The default bootstrap and pilot take longer than all the rest.
    for (const ParameterSpec& spec : info_.parameters) {
      if (spec.name == "bootstrap") parameters_["bootstrap"] = "3000";
      if (spec.name == "pilot-samples") parameters_["pilot-samples"] = "8";
    }
  }

  std::unique_ptr<Integrator> make() const {
    auto integrator = info_.make(scene_, settings_, info_.read(parameters_));
    prepare(*integrator);
    return integrator;
  }
  Film film(const Integrator& integrator) const { return film_for(scene_, settings_, integrator); }
  /// `times`: as many samples as the case has.
  RenderJobOptions options(int threads, std::uint64_t times = 1) const {
    RenderJobOptions options;
    options.budget.samples_per_pixel = times * samples_;
    options.threads = threads;
    return options;
  }
  Sums left_alone(std::uint64_t times = 1) const {
    const auto integrator = make();
    Film whole = film(*integrator);
    RenderJob(*integrator, whole, options(2, times)).run();
    return {whole.raw().begin(), whole.raw().end()};
  }

  const Scene& scene_;
  const IntegratorInfo& info_;
  std::string name_;
  RenderSettings settings_;
  std::map<std::string, std::string> parameters_;
  std::uint64_t samples_;
};

/// Scenes that differ in their film or sampler. Each method has one of them for each test, and each
/// scene a third of the methods.
constexpr std::array<const char*, 3> kScenes = {"Environment", "CroppedMitchell", "Fog"};

class Resume : public ::testing::TestWithParam<const char*> {
 protected:
  Resume() : scene_(test::scene_from(test::small_scene(GetParam()).text)) {}
  /// Methods that have this scene; `turn` distinguishes tests.
  std::vector<Case> cases(std::size_t turn) const {
    const auto number = static_cast<std::size_t>(
        std::find(kScenes.begin(), kScenes.end(), std::string(GetParam())) - kScenes.begin());
    std::vector<Case> cases;
    const std::vector<Method> all = methods();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if ((i + turn) % kScenes.size() == number) cases.emplace_back(*scene_, all[i]);
    }
    return cases;
  }
  std::unique_ptr<Scene> scene_;
};

Checkpoint checkpoint_of(const Case& one, const Integrator& integrator, const Film& film,
                         const RenderJob& job) {
  Checkpoint next;
  next.version = version();
  next.render.scene_hash = one.scene_.hash();
  next.render.settings = one.settings_;
  next.render.integrator = one.info_.name;
  next.layers.assign(film.layers().begin(), film.layers().end());
  next.job = job.state();
  next.scales = development_of(film, integrator, next.job.mean_samples());
  next.integrator_state = archived([&](OutputArchive& archive) { integrator.save_state(archive); });
  return next;
}

/// Restores a checkpoint.
Film take_up(const Case& one, Checkpoint read, Integrator& integrator, RenderJobOptions& options) {
  check_scene(read, one.scene_.hash(), integrator.layers(), "", false);
  unarchive(read.integrator_state, [&](InputArchive& archive) {
    integrator.load_state(archive, read.job.samples_per_pixel);
  });
  options.resumed = read.job;
  return film_of(read, one.film(integrator).filter(), "");
}

/// One pass, from the checkpoint in a file to the next; on the first pass there is none. Or only
/// its beginning (`cut`), as if the user could not wait.
void run_one_pass(const Case& one, const std::string& path, bool first, int threads, bool cut) {
  const auto integrator = one.make();
  Film film = one.film(*integrator);
  RenderJobOptions options = one.options(threads);
  if (!first) {
    film = take_up(one, read_checkpoint(path), *integrator, options);
  }
  options.pass_seconds = 0.0;
  class StopAfterPass final : public PassObserver {
   public:
    StopAfterPass(std::uint64_t passes, bool cut) : passes_(passes), cut_(cut) {}
    bool wants_picture(const JobState& state) override {
      if (state.passes > passes_) interrupts = 1;
      // The job has looked whether to stop already, and begins its pass.
      if (cut_) interrupts = 2;
      return false;
    }
    void see_picture(const Film& /*film*/, const JobState& /*state*/) override {}
    InterruptCount interrupts{0};

   private:
    std::uint64_t passes_;
    bool cut_;
  };
  StopAfterPass stop(options.resumed ? options.resumed->passes : 0, cut);
  options.interrupts = &stop.interrupts;
  options.observers = {&stop};
  RenderJob job(*integrator, film, options);
  job.run();
  write_checkpoint(path, checkpoint_of(one, *integrator, film, job), film.raw());
}

void expect_the_same_at_every_pass(const Case& one) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("ajar-resume-" + std::to_string(getpid())))
          .string();
  int runs = 0;
  Checkpoint last;
  do {
    constexpr int kThreads[] = {1, 2, 5};
    run_one_pass(one, path, runs == 0, kThreads[runs % 3], runs % 4 == 2);
    ++runs;
    last = read_checkpoint(path);
  } while ((last.job.partial || last.job.samples_per_pixel < one.samples_) && runs < 100);
  std::filesystem::remove(path);
  EXPECT_GE(runs, 3) << one.name_;
  EXPECT_EQ(last.sums, one.left_alone()) << one.name_;
}

TEST_P(Resume, AtEveryPassGivesTheSameBits) {
  for (const Case& one : cases(0)) expect_the_same_at_every_pass(one);
}

/// Paths of manifold connections are not saved, and found again.
TEST(ResumeThroughWater, AtEveryPassGivesTheSameBits) {
  const auto scene = test::scene_from(test::pbrt_scene(
      "LookAt 0 2.4 -2.2  0 0 0.1  0 1 0\nCamera \"perspective\" \"float fov\" [40]", 24, 16, R"(
LightSource "infinite" "rgb L" [0.02 0.02 0.02]
LightSource "point" "point from" [0.3 1.6 0.2] "rgb I" [1 1 1]
Material "matte" "rgb Kd" [0.7 0.6 0.5]
Shape "trianglemesh" "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] "integer indices" [0 2 1 0 3 2]
Material "glass" "float index" [1.33]
Shape "trianglemesh" "point P" [-2 0.5 -2  2 0.5 -2  2 0.6 2  -2 0.4 2] "integer indices" [0 2 1 0 3 2]
)"));
  // Enough samples for epochs of several passes.
  const Method method{"selective", {}, {}, 64};
  const Case one(*scene, method);
  expect_the_same_at_every_pass(one);
}

TEST_P(Resume, OnSeveralRanksGivesTheSameBits) {
  for (const Case& one : cases(1)) {
    const Sums alone = one.left_alone();
    for (const int count : {2, 3}) {
      ThreadRanks ranks(count);
      Sums together;
      Checkpoint last;
      std::vector<std::thread> threads;
      threads.reserve(static_cast<std::size_t>(count));
      for (int rank = 0; rank < count; ++rank) {
        threads.emplace_back([&, rank] {
          const auto integrator = one.make();
          Film film = one.film(*integrator);
          RenderJobOptions options = one.options(1);
          options.ranks = &ranks.member(rank);
          RenderJob job(*integrator, film, options);
          job.run();
          if (rank != 0) return;
          together.assign(job.film().raw().begin(), job.film().raw().end());
          last = checkpoint_of(one, *integrator, job.film(), job);
        });
      }
      for (std::thread& thread : threads) thread.join();
      EXPECT_EQ(together, alone) << one.name_ << ", " << count << " ranks";
      if (count < 3) continue;
      // The root writes checkpoints: it must have the state of the others.
      last.sums = together;
      const auto integrator = one.make();
      RenderJobOptions options = one.options(2, 2);
      Film film = take_up(one, last, *integrator, options);
      RenderJob(*integrator, film, options).run();
      EXPECT_EQ(Sums(film.raw().begin(), film.raw().end()), one.left_alone(2))
          << one.name_ << ", alone after " << count << " ranks";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Resume, ::testing::ValuesIn(kScenes),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace ajar
