#include "measuring/measured_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "image/metrics.h"
#include "image/relative_error.h"
#include "measuring/reference_store.h"
#include "measuring/timed_render.h"
#include "session/render_setup.h"

namespace ajar::bench {

namespace {

constexpr Vec2i kSize(160, 120);
constexpr int kDefaultDepth = 16;
/// Far from those of the renders that are compared with it.
constexpr std::uint64_t kReferenceSeed = 2'000'000;
constexpr std::array<const char*, 2> kMethods = {"bdpt", "mmlt+"};

void average(const std::vector<ReferencePart>& parts, MeasuredScene& scene) {
  std::vector<double> weights;
  double whole = 0.0;
  for (const ReferencePart& part : parts) {
    const double noise = noise_floor(part.picture, part.standard_error).trimmed;
    weights.push_back(1.0 / std::max(1e-12, noise));
    whole += weights.back();
  }
  const std::size_t values = parts.front().picture.size();
  scene.truth.resize(values);
  std::vector<float> off_by_one_error(values);
  for (std::size_t i = 0; i < values; ++i) {
    double sum = 0.0;
    double variance = 0.0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const double weight = weights[p] / whole;
      const double error = weight * double{parts[p].standard_error[i]};
      sum += weight * double{parts[p].picture[i]};
      variance += error * error;
    }
    scene.truth[i] = static_cast<float>(sum);
    off_by_one_error[i] = static_cast<float>(sum + std::sqrt(variance));
  }
  scene.truth_floor = {relative_mse(off_by_one_error, scene.truth),
                       relative_mse_trimmed(off_by_one_error, scene.truth)};
  scene.truth_error = relative_error(off_by_one_error, scene.truth).value_or(0.0);
}

/// False if interrupted.
bool render_reference(const MeasuredScene& scene, std::size_t which, double cpu_seconds,
                      const ReferenceStore& store) {
  const char* method = kMethods[which];
  fmt::print(stderr, "{}: reference by {}, {:.0f} CPU-seconds\n", scene.name, method, cpu_seconds);
  RenderSettings settings = scene.settings;
  // Both make some of the light alike: with one seed, they would have the same noise in it.
  settings.seed = kReferenceSeed + which;
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
  std::vector<ReferencePart> parts;
  for (std::size_t which = 0; which < kMethods.size(); ++which) {
    const ReferenceStore store(measure.folder, {scene.name, size, scene.settings.max_depth,
                                                measure.box_filter ? "box" : "scene",
                                                kMethods[which], scene.scene->hash()});
    if (store.count() == 0 &&
        !render_reference(scene, which, measure.reference_seconds / kMethods.size(), store)) {
      return std::nullopt;
    }
    const std::vector<ReferencePart> own = store.load();
    const Reference reference = average(own);
    scene.references[which] = reference.picture;
    parts.insert(parts.end(), own.begin(), own.end());
  }
  average(parts, scene);
  return scene;
}

}  // namespace ajar::bench
