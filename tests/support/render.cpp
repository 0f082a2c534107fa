#include "support/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <numeric>
#include <utility>

#include "core/milestones.h"
#include "core/parallel_for.h"
#include "image/make_filter.h"
#include "import/pbrt/pbrt_import.h"
#include "integrator/integrator.h"
#include "session/preparation.h"
#include "session/scene_file.h"

namespace ajar::test {

std::unique_ptr<Scene> scene_from(const std::string& pbrt_text, bool may_warn) {
  Warnings warnings;
  desc::SceneDesc description = import_pbrt_text(pbrt_text, "test.pbrt", ".", warnings);
  auto scene = std::make_unique<Scene>(std::move(description), BuildOptions{}, warnings);
  if (!may_warn) {
    for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  }
  return scene;
}

Scene builtin_scene(const std::string& name) {
  Warnings warnings;
  return {load_scene("builtin:" + name, warnings), BuildOptions{Vec2i(96, 72)}, warnings};
}

std::string pbrt_scene(const std::string& camera, int width, int height, const std::string& world,
                       const std::string& filter) {
  return camera + "\nFilm \"image\" \"integer xresolution\" [" + std::to_string(width) +
         "] \"integer yresolution\" [" + std::to_string(height) + "]\n" + filter +
         "\nWorldBegin\n" + world + "\nWorldEnd\n";
}

std::vector<float> Render::layer(const std::string& name, std::optional<int> replicate) const {
  std::vector<float> sum;
  for (std::size_t i = 0; i < film->layers().size(); ++i) {
    const LayerSpec& spec = film->layers()[i];
    if (spec.name != name && spec.part_of != name) continue;
    const auto index = static_cast<int>(i);
    const double scale = integrator->develop_scale(spec, samples, replicate);
    const std::vector<float> pixels =
        replicate ? film->develop_replicate(index, *replicate, scale) : film->develop(index, scale);
    sum.resize(pixels.size());
    std::transform(sum.begin(), sum.end(), pixels.begin(), sum.begin(), std::plus<>());
  }
  return sum;
}

namespace {
std::vector<float> light(const Render& render, std::optional<int> replicate) {
  std::vector<float> sum = render.layer("direct", replicate);
  const std::vector<float> indirect = render.layer("indirect", replicate);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += indirect[i];
  return sum;
}
}  // namespace

/// As if time were over in the middle of a round.
void skip_preparation_after(int rounds, Integrator& integrator) {
  Counters counters;
  for (int round = 0; round <= rounds; ++round) {
    const std::uint64_t items = integrator.begin_preparation(round).items;
    EXPECT_GT(items, 0U) << "no round " << round;
    const std::uint64_t run = round < rounds ? items : items / 2;
    for (std::uint64_t item = 0; item < run; ++item) {
      integrator.prepare_item(round, item, counters);
    }
  }
  integrator.skip_preparation();
}

std::vector<float> Render::image() const { return light(*this, std::nullopt); }
std::vector<float> Render::replicate(int index) const { return light(*this, index); }

double Render::mean() const {
  const std::vector<float> pixels = image();
  return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
}

RenderSettings settings_of(const Scene& scene, const RenderOptions& options) {
  RenderSettings settings;
  settings.resolution = scene.camera().resolution();
  settings.crop = options.crop.value_or(Box2i(Vec2i(0, 0), settings.resolution - Vec2i(1, 1)));
  settings.min_depth = options.min_depth;
  settings.max_depth = options.max_depth;
  settings.seed = options.seed;
  settings.replicates = options.replicates;
  settings.aovs = options.aovs;
  return settings;
}

Render render(const Scene& scene, const RenderOptions& options) {
  const IntegratorInfo& info = find_integrator(options.integrator);
  std::unique_ptr<Integrator> integrator =
      info.make(scene, settings_of(scene, options), info.read(options.parameters));
  Counters of_preparation;
  if (options.skip_after) {
    skip_preparation_after(*options.skip_after, *integrator);
  } else {
    of_preparation = prepare(*integrator);
  }
  Render result = render_with(std::move(integrator), scene, options);
  result.counters += of_preparation;
  return result;
}

Render render_with(std::unique_ptr<Integrator> made, const Scene& scene,
                   const RenderOptions& options, const AfterPass& after_pass) {
  const RenderSettings settings = settings_of(scene, options);
  Render result;
  result.integrator = std::move(made);
  Integrator& integrator = *result.integrator;
  result.film =
      std::make_unique<Film>(settings.resolution, settings.crop, make_filter(scene.film().filter),
                             options.replicates, integrator.layers());
  result.samples = static_cast<std::uint64_t>(options.samples);
  const auto replicates = static_cast<std::uint64_t>(options.replicates);
  std::mutex mutex;
  for (std::uint64_t first = 0; first < result.samples;) {
    const std::uint64_t samples =
        std::min(result.samples, milestone_after(first, replicates)) - first;
    integrator.begin_pass(first, samples, *result.film);
    parallel_for(integrator.items_in_pass(), [&](std::uint64_t item) {
      Counters own;
      integrator.run_item(item, first, samples, *result.film, own);
      const std::lock_guard lock(mutex);
      result.counters += own;
    });
    integrator.end_pass();
    first += samples;
    if (after_pass) after_pass(*result.film, first);
  }
  const Counters& counters = result.counters;
  EXPECT_EQ(counters.discarded_nan + counters.discarded_infinite + counters.discarded_negative, 0U)
      << counters.first_discarded;
  return result;
}

}  // namespace ajar::test
