#include <fmt/format.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "core/error.h"
#include "image/make_filter.h"
#include "scene/scene.h"
#include "session/catalog.h"
#include "session/interrupts.h"
#include "session/option_values.h"
#include "session/output.h"
#include "session/preparation.h"
#include "session/progress.h"
#include "session/render_job.h"
#include "session/render_setup.h"
#include "session/resources.h"
#include "session/scene_file.h"
#include "session/stats_json.h"

namespace ajar::cli {

namespace {

constexpr int kExitFile = 4;
constexpr int kExitInterrupted = 130;

/// Decimal digits only: a seed that is silently changed would give a picture that another seed
/// gives too.
std::uint64_t parse_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc() || stopped != end) {
    throw UsageError("--seed: \"" + text +
                     "\" is not a whole number from 0 to 18446744073709551615");
  }
  return seed;
}

float checked_exposure(float stops) {
  constexpr float kMostStops = 64.F;
  if (!(std::abs(stops) <= kMostStops)) {
    throw UsageError(fmt::format("--exposure: {} is not within -{} and {} stops", stops, kMostStops,
                                 kMostStops));
  }
  return stops;
}

/// Files that a render writes over each other would be lost.
void check_distinct(const std::vector<std::string>& files) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& file : files) {
    const std::filesystem::path path = std::filesystem::absolute(file).lexically_normal();
    if (std::find(paths.begin(), paths.end(), path) != paths.end()) {
      throw UsageError(file + ": this file would be written twice");
    }
    paths.push_back(path);
  }
}

RenderRequest request_of(const RenderArguments& a) {
  RenderRequest request;
  request.integrator = a.integrator;
  if (!a.integrator.empty()) find_integrator(a.integrator);
  request.parameters = parse_assignments("--set", a.assignments);
  request.budget.samples_per_pixel = a.spp;
  if (!a.time.empty()) request.budget.seconds = parse_duration("--time", a.time);
  request.budget.target_error = a.target_error;
  if (!a.depth.empty()) request.depth = parse_depth("--depth", a.depth);
  if (!a.resolution.empty()) request.resolution = parse_resolution("--resolution", a.resolution);
  request.scale = a.scale;
  if (!a.crop.empty()) request.crop = parse_crop("--crop", a.crop);
  request.aovs = checked_aovs(parse_list(a.aovs));
  request.seed = parse_seed(a.seed);
  return request;
}

/// Memory that the machine does not have would be promised and then end the program without a word.
/// Wrong usage if the user chose the size, the scene's fault if its film did.
void check_memory(const RenderSetup& setup, const std::vector<LayerSpec>& layers,
                  bool size_from_scene) {
  const std::uint64_t needed = film_bytes(setup.crop, setup.settings.replicates, layers);
  const std::uint64_t available = physical_memory_bytes();
  if (available == 0 || needed < available / 10 * 9) return;
  const std::string message = fmt::format(
      "the film of {}x{} pixels needs {:.1f} GB of memory, this machine has {:.1f} GB; use a "
      "smaller --resolution or --crop, or fewer --aov",
      setup.resolution.x, setup.resolution.y, 1e-9 * static_cast<double>(needed),
      1e-9 * static_cast<double>(available));
  if (size_from_scene) throw SceneError({}, message);
  throw UsageError(message);
}

/// Prints where the files are; true if each is where it should be.
bool report_files(const std::vector<WrittenFile>& files) {
  bool all_written = true;
  for (const WrittenFile& file : files) {
    if (file.error.empty()) {
      fmt::print("{}\n", file.path);
      continue;
    }
    all_written = false;
    print_error(file.error);
    if (!file.path.empty()) {
      print_note("the picture is in " + file.path + " instead");
      fmt::print("{}\n", file.path);
    }
  }
  std::fflush(stdout);
  return all_written;
}

bool write_statistics(const RenderStatistics& statistics, const std::string& path) {
  if (path.empty()) return true;
  try {
    write_json(to_json(statistics), path);
    return true;
  } catch (const IoError& error) {
    print_error(error.what());
    return false;
  }
}

void report_discarded(const Counters& counters) {
  const std::uint64_t total =
      counters.discarded_nan + counters.discarded_infinite + counters.discarded_negative;
  if (total == 0) return;
  print_warning(
      fmt::format("{} contributions were dropped ({} NaN, {} infinite, {} negative); the first: {}",
                  total, counters.discarded_nan, counters.discarded_infinite,
                  counters.discarded_negative, counters.first_discarded));
}

void report_end(const RenderResult& result, bool chains) {
  std::string text = fmt::format(
      "{} {}{} per pixel in {}, {} rays/s", result.samples_per_pixel,
      chains ? "mutation" : "sample", result.samples_per_pixel == 1 ? "" : "s",
      clock_text(result.seconds),
      short_number(result.seconds > 0.0 ? static_cast<double>(result.counters.rays) / result.seconds
                                        : 0.0));
  if (result.relative_error) {
    text += fmt::format(", estimated error {:.2g} %", 100.0 * *result.relative_error);
  }
  if (result.stopped_by == StopReason::Interrupted) text += ", interrupted";
  print_note(text);
  if (!result.complete) {
    print_warning(
        "the last pass was cut short: parts of the picture have fewer samples than others, or "
        "none");
  }
}

}  // namespace

int render(const RenderArguments& a) {
  const ProgressStyle style = progress_style(a.progress, isatty(STDERR_FILENO) != 0);
  const DisplayOptions display{tone_map_by_name(a.tone_map), checked_exposure(a.exposure)};
  const RenderRequest request = request_of(a);
  check_picture_paths(a.outputs);
  if (!a.stats.empty()) check_writable(a.stats);
  std::vector<std::string> written = a.outputs;
  if (!a.stats.empty()) written.push_back(a.stats);
  check_distinct(written);
  std::unique_ptr<tbb::global_control> thread_limit;
  if (a.threads > 0) {
    thread_limit = std::make_unique<tbb::global_control>(
        tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(a.threads));
  }

  RenderStatistics statistics;
  statistics.scene = a.scene;
  Warnings warnings;
  report_phase(style, "load");
  const Stopwatch load_clock;
  desc::SceneDesc description = load_scene(a.scene, warnings);
  statistics.times.load = load_clock.seconds();

  const RenderSetup setup = make_setup(request, description.hints, description.film);
  const std::vector<std::string> outputs =
      a.outputs.empty() ? default_outputs(description.film.filename, scene_stem(a.scene))
                        : a.outputs;
  if (a.outputs.empty()) check_picture_paths(outputs);
  const Parameters parameters(setup.integrator->parameters, setup.parameters);
  const Filter filter = make_filter(description.film.filter, description.film.where);
  const float film_scale = description.film.scale;

  report_phase(style, "build");
  const Stopwatch build_clock;
  const Scene scene(std::move(description), BuildOptions{setup.resolution}, warnings);
  statistics.times.build = build_clock.seconds();
  print_warnings(warnings, a.stats.empty() ? "" : "see " + a.stats);
  for (const std::string& note : setup.notes) print_note(note);

  report_phase(style, "prepare");
  const Stopwatch prepare_clock;
  const std::unique_ptr<Integrator> integrator =
      setup.integrator->make(scene, setup.settings, parameters);
  statistics.preparation = prepare(*integrator);
  for (const std::string& concern : integrator->concerns()) {
    warnings.add(concern);
    print_warning(concern);
  }
  for (const std::string& note : integrator->notes()) print_note(note);
  const std::vector<LayerSpec> layers = integrator->layers();
  // "all" means what the method can make.
  if (parse_list(a.aovs) != std::vector<std::string>{"all"}) {
    std::vector<LayerSpec> made = layers;
    for (const auto& [name, plane] : integrator->maps()) made.push_back({.name = name});
    check_layers(setup.settings, made);
  }
  check_memory(setup, layers, a.resolution.empty() && !a.scale);
  Film film(setup.resolution, setup.crop, filter, setup.settings.replicates, layers);
  statistics.times.prepare = prepare_clock.seconds();

  begin_render();
  report_phase(style, "render");
  RenderJobOptions options;
  options.budget = setup.budget;
  // A time limit covers everything after loading.
  if (options.budget.seconds) {
    *options.budget.seconds -= statistics.times.build + statistics.times.prepare;
  }
  options.threads = a.threads;
  options.estimate_error = [&](const Film& f, std::uint64_t samples) {
    return estimate_error(f, *integrator, samples);
  };
  options.interrupts = &interrupt_count();
  RenderJob job(*integrator, film, std::move(options));
  {
    const ProgressReporter progress(style, [&job] { return job.snapshot(); });
    statistics.result = job.run();
  }
  const RenderResult& result = statistics.result;

  statistics.chains = integrator->chain_report();
  statistics.selective = integrator->selective_report();
  statistics.scene_hash = scene.hash();
  statistics.integrator = setup.integrator->name;
  statistics.parameters = parameters.values();
  statistics.seed = request.seed;
  statistics.replicates = setup.settings.replicates;
  statistics.min_depth = setup.settings.min_depth;
  statistics.max_depth = setup.settings.max_depth;
  statistics.resolution = setup.resolution;
  statistics.crop = setup.crop;
  statistics.warning_count = warnings.count();
  statistics.warnings = warnings.messages();

  report_phase(style, "write");
  Picture picture = develop(film, *integrator, result.samples_per_pixel, film_scale, setup.aovs);
  picture.metadata = to_metadata(statistics);
  const std::vector<WrittenFile> files = write_pictures(picture, outputs, display);
  for (const WrittenFile& file : files) {
    if (!file.path.empty()) statistics.outputs.push_back(file.path);
  }
  statistics.peak_memory_bytes = peak_memory_bytes();
  const bool stats_written = write_statistics(statistics, a.stats);
  report_discarded(result.counters);
  report_end(result, statistics.chains && !statistics.selective);
  const bool files_written = report_files(files);
  if (!files_written || !stats_written) return kExitFile;
  return result.stopped_by == StopReason::Interrupted ? kExitInterrupted : 0;
}

}  // namespace ajar::cli
