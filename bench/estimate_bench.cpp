#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <set>

#include "image/relative_error.h"
#include "integrator/integrator.h"
#include "measuring/bench_main.h"
#include "measuring/bench_scenes.h"
#include "measuring/csv_keys.h"
#include "measuring/measured_scene.h"
#include "measuring/timed_render.h"
#include "session/job/interrupts.h"

/// Accuracy of estimated errors: renders scenes by all integrators and writes a line of CSV for
/// each render with both errors. Renders already in the file are skipped, so that an interrupted
/// study is resumed. `bench/results.py` makes tables of the lines.
namespace ajar::bench {
namespace {

constexpr const char* kHeader =
    "scene,integrator,cpu_seconds,seed,spent,samples,true_error,reference_error,estimated,"
    "fireflies,misses_light,places";

struct Arguments {
  std::string file = "build/estimates.csv";
  std::vector<double> seconds = {4.0};
  int seeds = 8;
  std::vector<std::string> integrators;
  std::vector<std::string> scenes;
  MeasureOptions measure;
};

bool interrupted() { return interrupt_count() > 0; }

std::string key_of(const std::string& scene, const std::string& integrator, double seconds,
                   int seed) {
  return fmt::format("{},{},{:g},{}", scene, integrator, seconds, seed);
}

std::string line_of(const MeasuredScene& scene, const std::string& key,
                    const std::string& integrator, double seconds, int seed) {
  RenderSettings settings = scene.settings;
  settings.seed = static_cast<std::uint64_t>(seed);
  const TimedRender render =
      render_for({seconds}, *scene.scene, parse_variant(integrator), settings, interrupt_count());
  const double against = relative_error(render.picture, scene.references.mean).value_or(0.0);
  const double true_error =
      std::sqrt(std::max(0.0, against * against - scene.references.error * scene.references.error));
  const std::string about = fmt::format("{},{:.2f},{},{:.5g},{:.5g}", key, render.cpu_seconds,
                                        render.samples, true_error, scene.references.error);
  if (!render.estimate) return about + ",,,,\n";
  return fmt::format("{},{:.5g},{:d},{:d},{:.4g}\n", about, render.estimate->value,
                     render.estimate->has_fireflies, render.estimate->misses_light,
                     render.estimate->places);
}

void measure(const BenchScene& scene, const Arguments& arguments) {
  const std::set<std::string> done = csv_keys(arguments.file, 4);
  std::optional<MeasuredScene> measured;
  for (int seed = 1; seed <= arguments.seeds; ++seed) {
    for (const double seconds : arguments.seconds) {
      for (const std::string& integrator : arguments.integrators) {
        const std::string key = key_of(scene.name, integrator, seconds, seed);
        if (done.contains(key)) continue;
        if (!measured) {
          measured = measure_scene(scene, arguments.measure);
        }
        if (interrupted() || !measured) return;
        const std::string line = line_of(*measured, key, integrator, seconds, seed);
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
  app.add_option("file", arguments.file, "CSV file");
  app.add_option("--seconds", arguments.seconds, "CPU-seconds of a render")->delimiter(',');
  app.add_option("--seeds", arguments.seeds, "Seeds, from 1");
  app.add_option("--integrators", arguments.integrators, "Default: all")->delimiter(',');
  add_measure_options(app, arguments.scenes, arguments.measure);
  CLI11_PARSE(app, count, texts);
  if (arguments.integrators.empty()) {
    for (const IntegratorInfo& info : integrators()) arguments.integrators.push_back(info.name);
  }
  begin_csv(arguments.file, kHeader);
  return measure_each(scenes_of(arguments.scenes),
                      [&](const BenchScene& scene) { measure(scene, arguments); });
}

}  // namespace
}  // namespace ajar::bench

int main(int argc, char** argv) {
  return ajar::bench::bench_main("ajar_estimate_bench",
                                 [&] { return ajar::bench::run(argc, argv); });
}
