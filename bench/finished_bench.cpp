#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/error.h"
#include "image/flip.h"
#include "image/metrics.h"
#include "image/tone_curve.h"
#include "integrator/integrator.h"
#include "integrator/scene_features.h"
#include "measuring/bench_scenes.h"
#include "measuring/csv_keys.h"
#include "measuring/measured_scene.h"
#include "measuring/timed_render.h"
#include "post/denoise/denoiser.h"
#include "post/denoise/mix_estimates.h"
#include "session/builtin_scenes.h"
#include "session/interrupts.h"
#include "session/write_picture.h"

/// The finished picture: errors raw, by scale and after each filter, of equal CPU time. Writes a
/// line of CSV for each render and filter, and does not render again what the file has.
/// `bench/finished_table.py` makes tables of the lines.
namespace ajar::bench {
namespace {

constexpr int kExitInterrupted = 130;
constexpr const char* kHeader =
    "scene,method,cpu_seconds,seed,spent,samples,reference_relmse,relmse,trimmed,p999,e1,e2,e4,e8,"
    "flip,filter,filtered_relmse,filtered_trimmed,filtered_flip";

struct Arguments {
  std::string file = "build/finished.csv";
  std::vector<double> seconds = {5.0, 20.0};
  int seeds = 4;
  std::vector<std::string> methods = {"pt", "ibpt", "bdpt", "mmlt", "selective"};
  std::vector<std::string> scenes;
  std::vector<std::string> filters = {"oidn"};
  std::string pictures;  ///< folder; empty: none are kept
  MeasureOptions measure{.longer_side = 240, .box_filter = true};
};

bool interrupted() { return interrupt_count() > 0; }

/// A filter with a scene's features.
struct ReadyFilter {
  std::string name;
  std::shared_ptr<const Denoiser> denoiser;
  Features features;
};

std::vector<ReadyFilter> make_filters(const MeasuredScene& scene, const Arguments& arguments) {
  const Features features = trace_features(*scene.scene, scene.settings);
  std::vector<ReadyFilter> filters;
  for (const std::string& name : arguments.filters) {
    const std::shared_ptr<const Denoiser> denoiser = find_denoiser(name);
    filters.push_back({name, denoiser, denoiser->prepare(scene.settings.resolution, features)});
  }
  return filters;
}

std::string raw_columns(const MeasuredScene& scene, const TimedRender& render) {
  const std::vector<float>& picture = render.picture;
  const auto at_scale = [&](double sigma) {
    return relative_mse_at_scale(picture, scene.truth, scene.settings.resolution, sigma);
  };
  return fmt::format(
      "{:.2f},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g}", render.cpu_seconds,
      render.samples, scene.truth_floor.plain, relative_mse(picture, scene.truth),
      relative_mse_trimmed(picture, scene.truth), relative_mse_quantile(picture, scene.truth),
      at_scale(1.0), at_scale(2.0), at_scale(4.0), at_scale(8.0),
      map_mean(flip_map(to_ldr(picture), to_ldr(scene.truth), scene.settings.resolution)));
}

std::string filtered_columns(const MeasuredScene& scene, const std::vector<float>& denoised) {
  return fmt::format(
      "{:.4g},{:.4g},{:.4g}", relative_mse(denoised, scene.truth),
      relative_mse_trimmed(denoised, scene.truth),
      map_mean(flip_map(to_ldr(denoised), to_ldr(scene.truth), scene.settings.resolution)));
}

void keep_picture(const std::string& path, const MeasuredScene& scene, const TimedRender& render,
                  const std::vector<float>& filtered) {
  Picture picture;
  picture.resolution = scene.settings.resolution;
  picture.crop = scene.settings.crop;
  picture.layers.push_back({"", 3, render.picture});
  picture.layers.push_back({kDenoisedLayer, 3, filtered});
  for (const char* extension : {".exr", ".png"}) write_picture(path + extension, picture);
}

/// The lines of a render, one for each filter.
std::string lines_of(const MeasuredScene& scene, const std::string& key, const std::string& method,
                     double seconds, int seed, const std::vector<ReadyFilter>& filters,
                     const Arguments& arguments) {
  RenderSettings settings = scene.settings;
  settings.seed = static_cast<std::uint64_t>(seed);
  settings.other_estimates = true;
  const TimedRender render =
      render_for({seconds}, *scene.scene, parse_variant(method), settings, interrupt_count());
  if (interrupted()) return {};
  const std::string raw = raw_columns(scene, render);
  std::string lines;
  for (const ReadyFilter& filter : filters) {
    const auto filtered = [&](const std::vector<float>& picture) {
      return *filter.denoiser->filter({settings.resolution, picture, {}, {}}, filter.features, {});
    };
    const std::vector<float> whole = filtered(render.picture);
    const auto add = [&](const std::string& name, const std::vector<float>& picture) {
      lines += fmt::format("{},{},{},{}\n", key, raw, name, filtered_columns(scene, picture));
      if (arguments.pictures.empty()) return;
      std::string label = method;
      std::replace(label.begin(), label.end(), ':', '-');
      keep_picture(fmt::format("{}/{}-{}-{:g}-{}-{}", arguments.pictures, scene.name, label, seconds,
                               seed, name),
                   scene, render, picture);
    };
    add(filter.name, whole);
    BiasedEstimate by_chains{whole, {}};
    for (const std::vector<float>& part : render.estimates.replicates) {
      by_chains.replicates.push_back(filtered(part));
    }
    if (!render.estimates.others.empty()) {
      BiasedEstimate by_omc{filtered(replicate_mean(render.estimates.others)), {}};
      for (const std::vector<float>& part : render.estimates.others) {
        by_omc.replicates.push_back(filtered(part));
      }
      add(filter.name + "+omc", by_omc.pixels);
      add(filter.name + "+mix",
          mix_estimates(settings.resolution, {by_omc, by_chains}, render.estimates.replicates).pixels);
    }
  }
  return lines;
}

void measure(const BenchScene& bench_scene, const Arguments& arguments) {
  const std::set<std::string> done = csv_keys(arguments.file, 4);
  std::optional<MeasuredScene> scene;
  std::vector<ReadyFilter> filters;
  for (const double seconds : arguments.seconds) {
    for (int seed = 1; seed <= arguments.seeds; ++seed) {
      for (const std::string& method : arguments.methods) {
        const std::string key =
            fmt::format("{},\"{}\",{:g},{}", bench_scene.name, method, seconds, seed);
        if (done.contains(key)) continue;
        if (!scene) {
          scene = measure_scene(bench_scene, arguments.measure);
          if (interrupted() || !scene) return;
          filters = make_filters(*scene, arguments);
        }
        const std::string lines =
            lines_of(*scene, key, method, seconds, seed, filters, arguments);
        if (interrupted()) return;
        std::ofstream(arguments.file, std::ios::app) << lines;
        fmt::print(stderr, "{}", lines);
      }
    }
  }
}

int run(int count, char** texts) {
  Arguments arguments;
  CLI::App app("Writes errors of finished pictures to a CSV file, and goes on with it.");
  app.add_option("file", arguments.file, "CSV file");
  app.add_option("--seconds", arguments.seconds, "CPU-seconds of a render")->delimiter(',');
  app.add_option("--seeds", arguments.seeds, "Seeds, from 1");
  app.add_option("--methods", arguments.methods, "Integrators with settings, such as pt:cull=0");
  app.add_option("--scenes", arguments.scenes, "Default: the built-in ones")->delimiter(',');
  app.add_option("--filters", arguments.filters, "As --denoise of ajar takes them")->delimiter(',');
  app.add_option("--pictures", arguments.pictures, "Folder where pictures are kept");
  app.add_option("--longer-side", arguments.measure.longer_side, "Pixels");
  app.add_option("--references", arguments.measure.folder, "Folder of references");
  app.add_option("--reference-seconds", arguments.measure.reference_seconds,
                 "CPU-seconds of a reference that is made");
  CLI11_PARSE(app, count, texts);
  if (arguments.scenes.empty()) arguments.scenes = builtin_scene_names();
  begin_csv(arguments.file, kHeader);
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
    fmt::print(stderr, "ajar_finished_bench: {}\n", error.what());
    return error.exit_code();
  }
}
