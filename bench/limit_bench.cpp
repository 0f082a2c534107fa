#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdio>

#include "allocations.h"
#include "core/parallel_for.h"
#include "measuring/bench_scenes.h"
#include "measuring/job.h"
#include "measuring/split_arguments.h"
#include "measuring/variant.h"

/// The limit ratio (docs/develop/performance.md): time of a render over the time Embree alone needs
/// for exactly the rays the render traced. Both are measured in turn, in one run on one thread, so
/// that the machine's mood cancels; medians are printed. With them: heap allocations per sample,
/// how much faster two threads are than one, and what a sample per pixel costs compared with the
/// first variant.
namespace ajar::bench {
namespace {

constexpr int kRepeats = 5;
constexpr int kLongSide = 256;
constexpr std::uint64_t kMaxRays = 3'000'000;

double parallel_seconds(const Job& job, int threads) {
  tbb::task_arena arena(threads);
  return seconds([&] {
    arena.execute([&] { parallel_for(job.items, [&](std::uint64_t i) { job.run(i, i + 1); }); });
  });
}

/// Median, with the range in brackets.
std::string with_range(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{:.2f} ({:.2f}–{:.2f})", median(values), *least, *most);
}

/// Cost of a render beyond its rays.
struct LimitResult {
  std::vector<double> ratios;    ///< render over replay
  double rays_per_sample = 0.0;  ///< or mutation
  double allocations_per_sample = 0.0;
  double samples_per_second = 0.0;  ///< or mutations, on one thread
};

LimitResult measure_limit(Scene& scene, const Job& job) {
  // Record as many items as fit, evenly spread over the picture by taking all of them if possible.
  RayLog log;
  scene.log_rays(&log);
  std::uint64_t items = 0;
  Counters counters;
  while (items < job.items && log.entries.size() < kMaxRays) {
    counters += job.run(items, items + 1);
    ++items;
  }
  scene.log_rays(nullptr);

  LimitResult result;
  std::uint64_t allocated = 0;
  std::vector<double> render_seconds;
  for (int i = 0; i < kRepeats; ++i) {
    const std::uint64_t before = allocations();
    const double render = seconds([&] { job.run(0, items); });
    allocated = allocations() - before;
    render_seconds.push_back(render);
    result.ratios.push_back(render / seconds([&] { scene.replay(log); }));
  }
  const auto samples =
      static_cast<double>(counters.mutations > 0 ? counters.mutations : counters.samples);
  result.samples_per_second = samples / median(render_seconds);
  result.rays_per_sample = static_cast<double>(counters.rays) / samples;
  result.allocations_per_sample = static_cast<double>(allocated) / samples;
  return result;
}

/// Times of whole pictures with equally many samples per pixel.
struct PictureTimes {
  std::vector<double> over_first;  ///< time over that of the first variant
  std::vector<double> speedups;    ///< speedups by two threads
};

std::vector<PictureTimes> measure_pictures(const std::vector<Job>& jobs) {
  std::vector<PictureTimes> times(jobs.size());
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    double first = 0.0;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const double one = parallel_seconds(jobs[i], 1);
      if (i == 0) first = one;
      times[i].over_first.push_back(one / first);
      times[i].speedups.push_back(one / parallel_seconds(jobs[i], 2));
    }
  }
  return times;
}

void measure_scene(const BenchScene& bench_scene, const std::vector<Variant>& variants) {
  Warnings warnings;
  desc::SceneDesc description = bench_scene.load(warnings);
  const int max_depth = description.hints.max_depth.value_or(16);
  const Vec2i resolution = fitted_resolution(description.film.resolution, kLongSide);
  Scene scene(std::move(description), {.resolution = resolution}, warnings);
  std::vector<Job> jobs;
  jobs.reserve(variants.size());
  for (const Variant& variant : variants) jobs.push_back(make_job(scene, variant, max_depth));

  const std::vector<PictureTimes> times = measure_pictures(jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const LimitResult limit = measure_limit(scene, jobs[i]);
    fmt::print("| {} | {} | {} | {:.1f} | {:.2f} | {} | {:.4f} | {:.2f} | {} |\n", bench_scene.name,
               variants[i].text, scene.counts().instanced_triangles, limit.rays_per_sample,
               1e-6 * limit.samples_per_second, with_range(limit.ratios),
               limit.allocations_per_sample, median(times[i].speedups),
               with_range(times[i].over_first));
    std::fflush(stdout);
  }
}

/// `[SCENE…] [-- VARIANT…]`, by default all scenes and the path family.
void run(const std::vector<std::string>& arguments) {
  const SplitArguments split = split_arguments(arguments);
  const std::vector<Variant> variants =
      parse_variants(split.after.empty() ? default_variants() : split.after);
  const std::vector<BenchScene> all = bench_scenes();
  const std::vector<BenchScene> scenes =
      split.before.empty() ? all : choose_scenes(all, split.before);
  fmt::print(
      "limit ratio = render time / time Embree alone needs for the same rays (median of {} pairs, "
      "range)\n\n"
      "| scene | integrator | triangles | rays per sample or mutation | M of them per second | "
      "limit ratio | allocations/sample | 2 "
      "threads over 1 | cost per sample over {} |\n|---|---|---|---|---|---|---|---|---|\n",
      kRepeats, variants.front().text);
  std::fflush(stdout);
  for (const BenchScene& scene : scenes) measure_scene(scene, variants);
}

}  // namespace
}  // namespace ajar::bench

int main(int argc, char** argv) {
  try {
    ajar::bench::run({argv + 1, argv + argc});
  } catch (const ajar::Error& error) {
    fmt::print(stderr, "ajar_limit_bench: {}\n", error.what());
    return error.exit_code();
  }
  return 0;
}
