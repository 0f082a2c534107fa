#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "measuring/bench_main.h"
#include "measuring/bench_scenes.h"
#include "measuring/error_arguments.h"
#include "measuring/error_table.h"
#include "measuring/reference_store.h"
#include "measuring/shared_reference.h"
#include "measuring/timed_render.h"
#include "measuring/variant.h"
#include "session/job/interrupts.h"
#include "session/render/resolved_render.h"
#include "session/scenes/builtin_scenes.h"
#include "support/shared.h"

/// Errors after equal CPU time: every variant renders every scene for so many CPU-seconds, and the
/// pictures are compared with a long render that is kept for the next time.
namespace ajar::bench {
namespace {

constexpr int kDefaultDepth = 16;
/// Seeds of references, far from those of the renders that are compared with them.
constexpr std::uint64_t kFirstReferenceSeed = 1'000'000;
/// Differences of CPU time too small for another part of a reference, as a share.
constexpr double kSecondsTolerance = 0.05;

bool interrupted() { return interrupt_count() > 0; }

/// A scene, ready to be rendered by any variant.
struct Stage {
  std::string name;
  std::unique_ptr<Scene> scene;
  RenderSettings settings;
};

Stage make_stage(const BenchScene& bench_scene, const ErrorArguments& arguments) {
  Warnings warnings;
  desc::SceneDesc description = bench_scene.load(warnings);
  if (arguments.filter == "box") description.film.filter = {};
  Stage stage;
  stage.name = bench_scene.name;
  const int max_depth =
      arguments.depth.value_or(description.hints.max_depth.value_or(kDefaultDepth));
  const BuildOptions options{arguments.scale
                                 ? scaled_resolution(description.film.resolution, *arguments.scale)
                                 : fitted_resolution(description.film.resolution, arguments.size)};
  stage.scene = std::make_unique<Scene>(std::move(description), options, warnings);
  stage.settings = settings_for(*stage.scene);
  stage.settings.max_depth = max_depth;
  return stage;
}

/// Loads stored parts, and renders and stores missing ones. May have no parts if interrupted.
std::vector<ReferencePart> reference_parts(const Stage& stage, const ErrorArguments& arguments) {
  const ReferenceStore store(arguments.reference_folder,
                             {stage.name, stage.settings.resolution, stage.settings.max_depth,
                              arguments.filter, arguments.reference_variant, stage.scene->hash()});
  std::vector<ReferencePart> parts = store.load();
  double missing = arguments.reference_seconds;
  for (const ReferencePart& part : parts) missing -= part.cpu_seconds;
  if (missing < kSecondsTolerance * arguments.reference_seconds) return parts;

  fmt::print(stderr, "{}: reference by {}, {:.0f} CPU-seconds\n", stage.name,
             arguments.reference_variant, missing);
  RenderSettings settings = stage.settings;
  settings.seed = kFirstReferenceSeed + store.count();
  TimedRender render =
      render_for({missing, arguments.threads}, *stage.scene,
                 parse_variant(arguments.reference_variant), settings, interrupt_count());
  if (!render.complete) return parts;
  parts.push_back({std::move(render.picture), std::move(render.standard_error), render.samples,
                   render.cpu_seconds});
  store.add(parts.back());
  return parts;
}

double sum(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The reference, and a sentence about it.
Reference make_reference(const Stage& stage, const std::vector<ReferencePart>& parts,
                         const ErrorArguments& arguments, std::string& about) {
  Reference reference = average(parts);
  about = fmt::format("{}, {} samples per pixel, {:.0f} CPU-seconds in {} part{}",
                      arguments.reference_variant, reference.samples, reference.cpu_seconds,
                      reference.parts, reference.parts == 1 ? "" : "s");
  if (!arguments.shared_reference) return reference;
  const auto folder = test::shared_folder();
  const auto shared = folder ? shared_reference(*folder, stage.name, stage.settings.resolution,
                                                stage.settings.max_depth)
                             : std::nullopt;
  if (!shared) {
    about += "; no shared one at this size and depth";
    return reference;
  }
  const double own_sum = sum(reference.picture);
  const double own_floor = reference.floor.trimmed;
  reference = average_with(reference, *shared);
  about +=
      fmt::format(" (floor {:.2g}), averaged with the shared one (sum of ours over theirs {:.4f})",
                  own_floor, own_sum / sum(*shared));
  return reference;
}

void print_results(const Stage& stage, const Reference& reference, const std::string& about,
                   const std::vector<VariantMeasurements>& results,
                   const ErrorArguments& arguments) {
  fmt::print(
      "\n## {}\n\n{}×{}, depth {}, filter: {}. Reference: {}; its noise floor, trimmed "
      "{:.2g}, plain {:.2g}, is subtracted.\n\n{}",
      stage.name, stage.settings.resolution.x, stage.settings.resolution.y,
      stage.settings.max_depth, arguments.filter, about, reference.floor.trimmed,
      reference.floor.plain, error_table(results, arguments.seconds));
  const bool floor_decides =
      std::any_of(results.begin(), results.end(), [&](const VariantMeasurements& variant) {
        return std::any_of(variant.runs.begin(), variant.runs.end(), [&](const Measurement& run) {
          return run.trimmed * arguments.seconds / run.cpu_seconds < reference.floor.trimmed;
        });
      });
  if (floor_decides) {
    fmt::print(
        "\nThe noise of the reference is larger than some of these errors: a larger "
        "--reference-seconds makes them sure.\n");
  }
  std::fflush(stdout);
}

void measure_scene(const BenchScene& bench_scene, const std::vector<Variant>& variants,
                   const ErrorArguments& arguments) {
  const Stage stage = make_stage(bench_scene, arguments);
  const std::vector<ReferencePart> parts = reference_parts(stage, arguments);
  if (interrupted() || parts.empty()) return;
  std::string about;
  const Reference reference = make_reference(stage, parts, arguments, about);

  std::vector<VariantMeasurements> results;
  results.reserve(variants.size());
  for (const Variant& variant : variants) results.push_back({variant.text, {}});
  // Variants in turn for each seed, so that slow changes of the machine fall on all alike.
  for (int repeat = 0; repeat < arguments.repeats && !interrupted(); ++repeat) {
    for (std::size_t i = 0; i < variants.size(); ++i) {
      RenderSettings settings = stage.settings;
      settings.seed = static_cast<std::uint64_t>(repeat) + 1;
      const TimedRender render = render_for({arguments.seconds, arguments.threads}, *stage.scene,
                                            variants[i], settings, interrupt_count());
      if (interrupted()) break;
      const Measurement run =
          measure(render.picture, render.samples, render.cpu_seconds, reference, arguments.seconds);
      fmt::print(
          stderr, "{}: {}, seed {}: {} samples per pixel, {:.1f} CPU-seconds, error {:.3g}\n",
          stage.name, variants[i].text, settings.seed, run.samples, run.cpu_seconds, run.trimmed);
      results[i].runs.push_back(run);
    }
  }
  if (results.front().runs.empty()) return;
  print_results(stage, reference, about, results, arguments);
}

std::vector<BenchScene> wanted_scenes(const ErrorArguments& arguments) {
  const std::vector<BenchScene> all = bench_scenes();
  std::vector<std::string> names = arguments.scenes;
  if (names.empty()) {
    names = builtin_scene_names();
    const std::string shared = "veach-bidir";
    if (std::any_of(all.begin(), all.end(), [&](const auto& s) { return s.name == shared; })) {
      names.push_back(shared);
    }
  }
  return choose_scenes(all, names);
}

int run(const std::vector<std::string>& texts) {
  const auto arguments = parse_error_arguments(texts);
  if (!arguments) return 0;
  const std::vector<Variant> variants = parse_variants(arguments->variants);
  parse_variant(arguments->reference_variant);
  const std::vector<BenchScene> scenes = wanted_scenes(*arguments);
  fmt::print(
      "relMSE (ε = 0.01) after {:g} CPU-seconds, mean of {} seeds: each error, less the "
      "reference's own, times used over wanted CPU-seconds. Trimmed: without the worst 0.1 % of "
      "pixels.\n",
      arguments->seconds, arguments->repeats);
  std::fflush(stdout);
  return measure_each(scenes,
                      [&](const BenchScene& scene) { measure_scene(scene, variants, *arguments); });
}

}  // namespace
}  // namespace ajar::bench

int main(int argc, char** argv) {
  return ajar::bench::bench_main("ajar_error_bench", [&] {
    return ajar::bench::run({argv + 1, argv + argc});
  });
}
