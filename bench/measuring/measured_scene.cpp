#include "measuring/measured_scene.h"

#include <fmt/format.h>

#include <array>
#include <span>

#include "measuring/reference_store.h"
#include "measuring/timed_render.h"
#include "session/render/resolved_render.h"

namespace ajar::bench {

namespace {

constexpr Vec2i kSize(160, 120);
constexpr int kDefaultDepth = 16;
/// Far from those of the renders that are compared with it.
constexpr std::uint64_t kReferenceSeed = 2'000'000;

/// The next part of a reference by one of the methods. False if interrupted.
bool render_part(const MeasuredScene& scene, std::span<const std::string> methods,
                 std::size_t which, double cpu_seconds, const ReferenceStore& store) {
  const std::string& method = methods[which];
  fmt::print(stderr, "{}: reference by {}, {:.0f} CPU-seconds\n", scene.name, method, cpu_seconds);
  RenderSettings settings = scene.settings;
  // Methods share code: with one seed, some of their noise would be common.
  settings.seed = kReferenceSeed + which + methods.size() * store.count();
  TimedRender render =
      render_for({cpu_seconds}, *scene.scene, parse_variant(method), settings, interrupt_count());
  if (interrupt_count() > 0) return false;
  store.add({std::move(render.picture), std::move(render.standard_error), render.samples,
             render.cpu_seconds});
  return true;
}

}  // namespace

std::optional<MeasuredScene> measure_scene(const BenchScene& bench_scene,
                                           const MeasureOptions& measure) {
  Warnings warnings;
  desc::SceneDesc description = bench_scene.load(warnings);
  MeasuredScene scene;
  scene.name = bench_scene.name;
  const int max_depth = description.hints.max_depth.value_or(kDefaultDepth);
  if (measure.box_filter) description.film.filter = {};
  const Vec2i size = measure.longer_side > 0
                         ? fitted_resolution(description.film.resolution, measure.longer_side)
                         : kSize;
  scene.description = description;
  scene.scene = std::make_unique<Scene>(std::move(description), BuildOptions{size}, warnings);
  scene.settings = settings_for(*scene.scene);
  scene.settings.max_depth = max_depth;
  std::vector<std::array<std::vector<float>, 2>> by_method;
  const std::vector<std::string>& methods = measure.reference_methods;
  for (std::size_t which = 0; which < methods.size(); ++which) {
    const ReferenceStore store(measure.folder, {scene.name, size, scene.settings.max_depth,
                                                measure.box_filter ? "box" : "scene",
                                                methods[which], scene.scene->hash()});
    constexpr std::size_t kHalves = 2;
    const double part_seconds = measure.reference_seconds / (kHalves * methods.size());
    while (store.count() < kHalves) {
      if (!render_part(scene, methods, which, part_seconds, store)) return std::nullopt;
    }
    std::array<std::vector<ReferencePart>, kHalves> parts;
    for (ReferencePart& part : store.load()) {
      std::vector<ReferencePart>& half = parts[0].size() > parts[1].size() ? parts[1] : parts[0];
      half.push_back(std::move(part));
    }
    by_method.push_back({average(parts[0]).picture, average(parts[1]).picture});
  }
  scene.references = reference_pair(by_method);
  return scene;
}

}  // namespace ajar::bench
