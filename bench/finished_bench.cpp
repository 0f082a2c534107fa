#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "image/blur.h"
#include "image/flip.h"
#include "image/metrics.h"
#include "image/relative_error.h"
#include "image/tone_curve.h"
#include "integrator/integrator.h"
#include "integrator/montecarlo/scene_features.h"
#include "measuring/bench_main.h"
#include "measuring/bench_scenes.h"
#include "measuring/csv_keys.h"
#include "measuring/measured_scene.h"
#include "measuring/reference.h"
#include "measuring/timed_render.h"
#include "post/denoise/denoiser.h"
#include "session/job/interrupts.h"
#include "session/output/picture_filter.h"
#include "session/output/write_picture.h"

/// The finished picture: errors raw, by scale and after each filter, of equal CPU time. Writes a
/// line of CSV for each render and filter, and does not render again what the file has.
/// `bench/results.py` makes tables of the lines.
namespace ajar::bench {
namespace {

constexpr const char* kHeader =
    "scene,method,cpu_seconds,seed,spent,samples,reference_relmse,relmse,trimmed,p999,e1,e2,e4,e8,"
    "flip,filter,filtered_relmse,filtered_trimmed,filtered_flip,filtered_error,filtered_estimate";

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
  std::unique_ptr<PictureFilter> filter;
};

std::vector<ReadyFilter> make_filters(const MeasuredScene& scene, const Arguments& arguments) {
  const auto tracer = std::make_shared<FeatureTracer>(*scene.scene, scene.settings);
  std::vector<ReadyFilter> filters;
  for (const std::string& name : arguments.filters) {
    filters.push_back({name, std::make_unique<PictureFilter>(
                                 find_denoiser(name),
                                 [tracer](std::uint32_t rays, const Denoiser::Progress& progress) {
                                   return tracer->look(rays, progress);
                                 })});
  }
  return filters;
}

std::string raw_columns(const MeasuredScene& scene, const TimedRender& render) {
  const std::vector<float>& picture = render.picture;
  const auto& [first, second] = scene.references.halves;
  const Vec2i size = scene.settings.resolution;
  const auto at_scale = [&](double sigma) {
    return own_error(blurred(picture, size, sigma), blurred(first, size, sigma),
                     blurred(second, size, sigma))
        .plain;
  };
  const OwnError error = own_error(picture, first, second);
  return fmt::format("{:.2f},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g}",
                     render.cpu_seconds, render.samples, scene.references.floor.plain, error.plain,
                     error.trimmed, relative_mse_quantile(picture, scene.references.mean),
                     at_scale(1.0), at_scale(2.0), at_scale(4.0), at_scale(8.0),
                     map_mean(flip_map(to_ldr(picture), to_ldr(scene.references.mean),
                                       scene.settings.resolution)));
}

/// With the error that is estimated of it, if any is, and the true one.
std::string filtered_columns(const MeasuredScene& scene, const Picture& picture) {
  const std::vector<float>& pixels = shown_layer(picture).pixels;
  const std::optional<double> estimate = denoised_error(picture);
  const OwnError error = own_error(pixels, scene.references.halves[0], scene.references.halves[1]);
  return fmt::format(
      "{:.4g},{:.4g},{:.4g},{:.4g},{}", error.plain, error.trimmed,
      map_mean(flip_map(to_ldr(pixels), to_ldr(scene.references.mean), scene.settings.resolution)),
      relative_error(pixels, scene.references.mean).value_or(0.0),
      estimate ? fmt::format("{:.4g}", *estimate) : "");
}

/// The lines of a render, two for each filter: of the picture alone, and of all that is known.
std::string lines_of(const MeasuredScene& scene, const std::string& key, const std::string& method,
                     double seconds, int seed, const std::vector<ReadyFilter>& filters,
                     const Arguments& arguments) {
  RenderSettings settings = scene.settings;
  settings.seed = static_cast<std::uint64_t>(seed);
  settings.for_filters = true;
  const TimedRender render =
      render_for({seconds}, *scene.scene, parse_variant(method), settings, interrupt_count());
  if (interrupted()) return {};
  const std::string raw = raw_columns(scene, render);
  std::string lines;
  for (const ReadyFilter& ready : filters) {
    for (const bool mixes : {false, true}) {
      Picture picture;
      picture.resolution = settings.resolution;
      picture.crop = settings.crop;
      picture.layers.push_back({"", 3, render.picture});
      if (mixes) {
        ready.filter->add_best_layers(picture, render.estimates);
      } else {
        ready.filter->add_layers(picture);
      }
      const std::string name = ready.name + (mixes ? "+mix" : "");
      lines += fmt::format("{},{},{},{}\n", key, raw, name, filtered_columns(scene, picture));
      if (arguments.pictures.empty()) continue;
      std::string label = method;
      std::replace(label.begin(), label.end(), ':', '-');
      for (const char* extension : {"exr", "png"}) {
        write_picture(fmt::format("{}/{}-{}-{:g}-{}-{}.{}", arguments.pictures, scene.name, label,
                                  seconds, seed, name, extension),
                      picture);
      }
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
        const std::string lines = lines_of(*scene, key, method, seconds, seed, filters, arguments);
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
  app.add_option("--filters", arguments.filters, "As --denoise of ajar takes them, but for none")
      ->delimiter(',')
      ->check(CLI::IsMember({"auto", "oidn", "builtin"}));
  app.add_option("--pictures", arguments.pictures, "Folder where pictures are kept");
  app.add_flag("!--scene-filter", arguments.measure.box_filter,
               "Films have the scenes' own filters, not boxes of one pixel");
  app.add_option("--longer-side", arguments.measure.longer_side, "Pixels");
  add_measure_options(app, arguments.scenes, arguments.measure);
  CLI11_PARSE(app, count, texts);
  if (!arguments.pictures.empty()) std::filesystem::create_directories(arguments.pictures);
  begin_csv(arguments.file, kHeader);
  return measure_each(scenes_of(arguments.scenes),
                      [&](const BenchScene& scene) { measure(scene, arguments); });
}

}  // namespace
}  // namespace ajar::bench

int main(int argc, char** argv) {
  return ajar::bench::bench_main("ajar_finished_bench",
                                 [&] { return ajar::bench::run(argc, argv); });
}
