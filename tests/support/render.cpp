#include "support/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "core/milestones.h"
#include "import/pbrt/pbrt_import.h"
#include "integrator/integrator.h"
#include "session/job/preparation.h"
#include "session/job/render_job.h"
#include "session/render/resolved_render.h"
#include "session/scenes/scene_file.h"

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
  return camera +
         "\nIntegrator \"volpath\" \"integer maxdepth\" 99 Film \"image\" \"integer xresolution\" "
         "[" +
         std::to_string(width) + "] \"integer yresolution\" [" + std::to_string(height) + "]\n" +
         filter + "\nWorldBegin\n" + world + "\nWorldEnd\n";
}

std::vector<float> Render::layer(const std::string& name, std::optional<int> replicate) const {
  std::vector<float> sum;
  for (std::size_t i = 0; i < film->layers().size(); ++i) {
    const LayerSpec& spec = film->layers()[i];
    if (spec.name != name && spec.part_of != name) continue;
    const auto index = static_cast<int>(i);
    const DevelopScale scale = integrator->develop_scale(spec, samples, replicate);
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

/// Cuts as if time were over in the middle of a round.
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
  integrator.skip_preparation(PreparationCut::Time);
}

std::vector<float> Render::image() const { return light(*this, std::nullopt); }
std::vector<float> Render::replicate(int index) const { return light(*this, index); }

double Render::mean() const {
  const std::vector<float> pixels = image();
  return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
}

RenderSettings settings_of(const Scene& scene, const RenderOptions& options) {
  RenderSettings settings = settings_for(scene);
  if (options.crop) settings.crop = *options.crop;
  settings.min_depth = options.min_depth;
  settings.max_depth = options.max_depth;
  settings.seed = options.seed;
  settings.replicates = options.replicates;
  settings.aovs = options.aovs;
  settings.for_filters = options.for_filters;
  return in_edges(settings, scene);
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

namespace {
/// Runs tests' changes between passes, where integrators adapt to their samples.
class AtMilestones final : public PassObserver {
 public:
  AtMilestones(int replicates, const AfterPass& act)
      : replicates_(static_cast<std::uint64_t>(replicates)), act_(act) {}
  bool wants_picture(const JobState& state) override {
    const std::uint64_t done = state.samples_per_pixel;
    return act_ && done > 0 && milestone_after(done - 1, replicates_) == done;
  }
  void see_picture(const Film& film, const JobState& state) override {
    act_(film, state.samples_per_pixel);
  }

 private:
  std::uint64_t replicates_;
  const AfterPass& act_;
};
}  // namespace

Render render_with(std::unique_ptr<Integrator> made, const Scene& scene,
                   const RenderOptions& options, const AfterPass& after_pass) {
  Render result;
  result.integrator = std::move(made);
  result.film =
      std::make_unique<Film>(film_for(scene, settings_of(scene, options), *result.integrator));
  AtMilestones observer(options.replicates, after_pass);
  RenderJobOptions job;
  job.budget.samples_per_pixel = static_cast<std::uint64_t>(options.samples);
  job.observers = {&observer};
  const RenderResult rendered = RenderJob(*result.integrator, *result.film, std::move(job)).run();
  result.samples = rendered.samples_per_pixel;
  result.counters = rendered.counters;
  const Counters& counters = result.counters;
  EXPECT_EQ(counters.discarded_nan + counters.discarded_infinite + counters.discarded_negative, 0U)
      << counters.first_discarded;
  return result;
}

}  // namespace ajar::test
