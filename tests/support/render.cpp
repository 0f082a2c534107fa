#include "support/render.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <mutex>
#include <numeric>

#include "image/make_filter.h"
#include "import/pbrt/pbrt_import.h"
#include "integrator/integrator.h"

namespace ajar::test {

std::unique_ptr<Scene> scene_from(const std::string& pbrt_text) {
  Warnings warnings;
  desc::SceneDesc description = import_pbrt_text(pbrt_text, "test.pbrt", ".", warnings);
  auto scene = std::make_unique<Scene>(std::move(description), BuildOptions{}, warnings);
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  return scene;
}

std::string pbrt_scene(const std::string& camera, int width, int height, const std::string& world,
                       const std::string& filter) {
  return camera + "\nFilm \"image\" \"integer xresolution\" [" + std::to_string(width) +
         "] \"integer yresolution\" [" + std::to_string(height) + "]\n" + filter +
         "\nWorldBegin\n" + world + "\nWorldEnd\n";
}

std::vector<float> Render::image() const {
  std::vector<float> sum = film->develop(film->layer("direct"), scale);
  const std::vector<float> indirect = film->develop(film->layer("indirect"), scale);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += indirect[i];
  return sum;
}

std::vector<float> Render::replicate(int index) const {
  const double own = replicate_scale[static_cast<std::size_t>(index)];
  std::vector<float> sum = film->develop_replicate(film->layer("direct"), index, own);
  const std::vector<float> indirect = film->develop_replicate(film->layer("indirect"), index, own);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += indirect[i];
  return sum;
}

double Render::mean() const {
  const std::vector<float> pixels = image();
  return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
}

Render render(const Scene& scene, const RenderOptions& options) {
  const IntegratorInfo& info = find_integrator(options.integrator);
  RenderSettings settings;
  settings.resolution = scene.camera().resolution();
  settings.crop = options.crop.value_or(Box2i(Vec2i(0, 0), settings.resolution - Vec2i(1, 1)));
  settings.min_depth = options.min_depth;
  settings.max_depth = options.max_depth;
  settings.seed = options.seed;
  settings.replicates = options.replicates;
  settings.aovs = options.aovs;
  const auto integrator =
      info.make(scene, settings, Parameters(info.parameters, options.parameters));
  Render result;
  result.film =
      std::make_unique<Film>(settings.resolution, settings.crop, make_filter(scene.film().filter),
                             options.replicates, integrator->layers());
  Counters counters;
  std::mutex mutex;
  const auto samples = static_cast<std::uint64_t>(options.samples);
  tbb::parallel_for(std::uint64_t{0}, integrator->items_in_pass(), [&](std::uint64_t item) {
    Counters own;
    integrator->run_item(item, 0, samples, *result.film, own);
    const std::lock_guard lock(mutex);
    counters += own;
  });
  EXPECT_EQ(counters.discarded_nan + counters.discarded_infinite + counters.discarded_negative, 0U)
      << counters.first_discarded;
  result.scale = integrator->develop_scale(samples, std::nullopt);
  for (int i = 0; i < options.replicates; ++i) {
    result.replicate_scale.push_back(integrator->develop_scale(samples, i));
  }
  return result;
}

}  // namespace ajar::test
