#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/error.h"
#include "image/relative_error.h"
#include "integrator/integrator.h"
#include "measuring/bench_scenes.h"
#include "measuring/reference_store.h"
#include "measuring/timed_render.h"
#include "session/builtin_scenes.h"
#include "session/interrupts.h"
#include "session/render_setup.h"

/// Whether estimated errors are true: renders scenes by all integrators and writes a line of CSV
/// for each render with both errors. What the file has already is not rendered again, so that the
/// study goes on where it was interrupted. `bench/estimate_table.py` makes a table of the lines.
namespace ajar::bench {
namespace {

constexpr int kExitInterrupted = 130;
constexpr int kDefaultDepth = 16;
constexpr std::uint64_t kFirstReferenceSeed = 2'000'000;
constexpr Vec2i kSize(160, 120);
/// Methods that fail in different places.
const std::vector<std::string> kReferenceMethods = {"bdpt", "mmlt"};
constexpr const char* kHeader =
    "scene,integrator,cpu_seconds,seed,spent,samples,true_error,reference_error,estimated,"
    "fireflies,misses_light,places";

struct Arguments {
  std::string file;
  std::vector<double> seconds = {4.0};
  int seeds = 8;
  std::vector<std::string> integrators;
  std::vector<std::string> scenes;
  std::string references = "build/estimate-references";
  double reference_seconds = 400.0;
};

struct Stage {
  std::string name;
  std::unique_ptr<Scene> scene;
  RenderSettings settings;
  std::vector<float> truth;
  double truth_error = 0.0;  ///< relative, of its own noise
};

bool interrupted() { return interrupt_count() > 0; }

/// Of parts of several methods, weighted by how certain they are as a whole.
void average(const std::vector<ReferencePart>& parts, Stage& stage) {
  const std::size_t values = parts.front().picture.size();
  std::vector<double> weights;
  double whole = 0.0;
  for (const ReferencePart& part : parts) {
    weights.push_back(1.0 /
                      std::max(1e-12, noise_floor(part.picture, part.standard_error).trimmed));
    whole += weights.back();
  }
  stage.truth.assign(values, 0.F);
  std::vector<float> off(values);
  for (std::size_t i = 0; i < values; ++i) {
    double sum = 0.0;
    double variance = 0.0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const double error = weights[p] / whole * parts[p].standard_error[i];
      sum += weights[p] / whole * parts[p].picture[i];
      variance += error * error;
    }
    stage.truth[i] = static_cast<float>(sum);
    off[i] = static_cast<float>(sum + std::sqrt(variance));
  }
  stage.truth_error = relative_error(off, stage.truth).value_or(0.0);
}

/// Empty if interrupted.
std::optional<Stage> make_stage(const BenchScene& bench_scene, const Arguments& arguments) {
  Warnings warnings;
  desc::SceneDesc description = bench_scene.load(warnings);
  Stage stage;
  stage.name = bench_scene.name;
  stage.settings.max_depth = description.hints.max_depth.value_or(kDefaultDepth);
  stage.settings.resolution = kSize;
  stage.settings.crop = Box2i(Vec2i(0, 0), kSize - Vec2i(1, 1));
  stage.settings.replicates = RenderSetup::kReplicates;
  stage.scene = std::make_unique<Scene>(std::move(description), BuildOptions{kSize}, warnings);
  std::vector<ReferencePart> parts;
  for (const std::string& method : kReferenceMethods) {
    const ReferenceStore store(arguments.references, {stage.name, kSize, stage.settings.max_depth,
                                                      "scene", method, stage.scene->hash()});
    if (store.count() == 0) {
      fmt::print(stderr, "{}: reference by {}\n", stage.name, method);
      RenderSettings settings = stage.settings;
      settings.seed = kFirstReferenceSeed;
      TimedRender render = render_for({arguments.reference_seconds / 2.0}, *stage.scene,
                                      parse_variant(method), settings, interrupt_count());
      if (interrupted()) return std::nullopt;
      store.add({std::move(render.picture), std::move(render.standard_error), render.samples,
                 render.cpu_seconds});
    }
    for (ReferencePart& part : store.load()) parts.push_back(std::move(part));
  }
  average(parts, stage);
  return stage;
}

std::string key_of(const std::string& scene, const std::string& integrator, double seconds,
                   int seed) {
  return fmt::format("{},{},{:g},{}", scene, integrator, seconds, seed);
}

/// The first four columns of the lines of a file.
std::set<std::string> keys_in(const std::string& path) {
  std::set<std::string> keys;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::size_t end = 0;
    for (int i = 0; i < 4 && end != std::string::npos; ++i) end = line.find(',', end + 1);
    keys.insert(line.substr(0, end));
  }
  return keys;
}

std::string line_of(const Stage& stage, const std::string& key, const std::string& integrator,
                    double seconds, int seed) {
  RenderSettings settings = stage.settings;
  settings.seed = static_cast<std::uint64_t>(seed);
  const TimedRender render =
      render_for({seconds}, *stage.scene, parse_variant(integrator), settings, interrupt_count());
  const double against = relative_error(render.picture, stage.truth).value_or(0.0);
  const double true_error =
      std::sqrt(std::max(0.0, against * against - stage.truth_error * stage.truth_error));
  const std::string about = fmt::format("{},{:.2f},{},{:.5g},{:.5g}", key, render.cpu_seconds,
                                        render.samples, true_error, stage.truth_error);
  if (!render.estimate) return about + ",,,,\n";
  return fmt::format("{},{:.5g},{:d},{:d},{:.4g}\n", about, render.estimate->value,
                     render.estimate->has_fireflies, render.estimate->misses_light,
                     render.estimate->places);
}

void measure(const BenchScene& scene, const Arguments& arguments) {
  const std::set<std::string> done = keys_in(arguments.file);
  std::optional<Stage> stage;
  for (int seed = 1; seed <= arguments.seeds; ++seed) {
    for (const double seconds : arguments.seconds) {
      for (const std::string& integrator : arguments.integrators) {
        const std::string key = key_of(scene.name, integrator, seconds, seed);
        if (done.contains(key)) continue;
        if (!stage) stage = make_stage(scene, arguments);
        if (interrupted()) return;
        const std::string line = line_of(*stage, key, integrator, seconds, seed);
        if (interrupted()) return;
        std::ofstream(arguments.file, std::ios::app) << line;
        fmt::print(stderr, "{}", line);
      }
    }
  }
}

int run(int count, char** texts) {
  Arguments arguments;
  CLI::App app("Writes estimated and true errors of renders to a CSV file, and goes on with it.");
  app.add_option("file", arguments.file, "CSV file")->required();
  app.add_option("--seconds", arguments.seconds, "CPU-seconds of a render")->delimiter(',');
  app.add_option("--seeds", arguments.seeds, "Seeds, from 1");
  app.add_option("--integrators", arguments.integrators, "Default: all")->delimiter(',');
  app.add_option("--scenes", arguments.scenes, "Default: the built-in ones")->delimiter(',');
  app.add_option("--references", arguments.references, "Folder of references");
  app.add_option("--reference-seconds", arguments.reference_seconds,
                 "CPU-seconds of a reference that is made");
  CLI11_PARSE(app, count, texts);
  if (arguments.integrators.empty()) {
    for (const IntegratorInfo& info : integrators()) arguments.integrators.push_back(info.name);
  }
  if (arguments.scenes.empty()) arguments.scenes = builtin_scene_names();
  if (!std::filesystem::exists(arguments.file)) {
    std::ofstream(arguments.file) << kHeader << '\n';
  }
  const std::vector<BenchScene> scenes = choose_scenes(bench_scenes(), arguments.scenes);
  begin_render();
  for (const BenchScene& scene : scenes) {
    measure(scene, arguments);
    if (interrupted()) return kExitInterrupted;
  }
  return 0;
}

}  // namespace
}  // namespace ajar::bench

int main(int argc, char** argv) {
  try {
    ajar::install_interrupt_handlers();
    return ajar::bench::run(argc, argv);
  } catch (const ajar::Error& error) {
    fmt::print(stderr, "ajar_estimate_bench: {}\n", error.what());
    return error.exit_code();
  }
}
