#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <filesystem>

#include "allocations.h"
#include "bench_scenes.h"
#include "job.h"
#include "many_lights.h"

/// The limit ratio of DESIGN, section 6: time of a render over the time Embree alone needs for
/// exactly the rays the render traced. Both are measured in turn, in one run on one thread, so that
/// the machine's mood cancels; medians are printed. With them: heap allocations per sample, and how
/// much faster two threads are than one.
namespace ajar::bench {
namespace {

constexpr int kRepeats = 5;
constexpr int kLongSide = 256;
constexpr std::uint64_t kMaxRays = 3'000'000;

double parallel_seconds(const Job& job, int threads) {
  tbb::task_arena arena(threads);
  return seconds([&] {
    arena.execute([&] {
      tbb::parallel_for(std::uint64_t{0}, job.items, [&](std::uint64_t i) { job.run(i, i + 1); });
    });
  });
}

void measure(const BenchScene& bench_scene, const std::string& integrator) {
  Warnings warnings;
  desc::SceneDesc description = bench_scene.load(warnings);
  const int max_depth = description.hints.max_depth.value_or(16);
  const Vec2i full = description.film.resolution;
  const double scale = static_cast<double>(kLongSide) / std::max(full.x, full.y);
  const Vec2i resolution(std::max(1, static_cast<int>(full.x * scale)),
                         std::max(1, static_cast<int>(full.y * scale)));
  Scene scene(std::move(description), {.resolution = resolution}, warnings);
  const Job job = make_job(scene, integrator, max_depth);

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

  std::vector<double> ratios;
  std::vector<double> speedups;
  std::uint64_t allocated = 0;
  for (int i = 0; i < kRepeats; ++i) {
    const std::uint64_t before = allocations();
    const double render = seconds([&] { job.run(0, items); });
    allocated = allocations() - before;
    const double replay = seconds([&] { scene.replay(log); });
    ratios.push_back(render / replay);
    const double one = parallel_seconds(job, 1);
    speedups.push_back(one / parallel_seconds(job, 2));
  }
  fmt::print("| {} | {} | {} | {:.1f} | {:.2f} ({:.2f}–{:.2f}) | {:.4f} | {:.2f} |\n",
             bench_scene.name, integrator, scene.counts().instanced_triangles,
             static_cast<double>(counters.rays) / static_cast<double>(counters.samples),
             median(ratios), *std::min_element(ratios.begin(), ratios.end()),
             *std::max_element(ratios.begin(), ratios.end()),
             static_cast<double>(allocated) / static_cast<double>(counters.samples),
             median(speedups));
  std::fflush(stdout);
}

}  // namespace
}  // namespace ajar::bench

int main(int argc, char** argv) {
  using namespace ajar::bench;
  const std::vector<std::string> wanted(argv + 1, argv + argc);
  const auto is_wanted = [&](const std::string& name) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  };
  if (is_wanted("many-lights")) measure_many_lights();
  if (wanted.size() == 1 && wanted.front() == "many-lights") return 0;
  fmt::print(
      "limit ratio = render time / time Embree alone needs for the same rays (median of 5 pairs, "
      "range)\n\n");
  fmt::print(
      "| scene | integrator | triangles | rays/sample | limit ratio | allocations/sample | 2 "
      "threads over 1 |\n");
  fmt::print("|---|---|---|---|---|---|---|\n");
  for (const BenchScene& scene : bench_scenes()) {
    if (!is_wanted(scene.name)) continue;
    try {
      measure(scene, "pt");
    } catch (const ajar::Error& error) {
      fmt::print(stderr, "{}: {}\n", scene.name, error.what());
      return error.exit_code();
    }
  }
  return 0;
}
