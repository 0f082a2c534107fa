#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "image/make_filter.h"
#include "session/preparation.h"
#include "session/render_job.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar {
namespace {

/// Fewer bootstrap samples for methods with chains, whose time in pictures this small is little
/// else; enough for several work items per population.
std::map<std::string, std::string> quick_parameters(const IntegratorInfo& info) {
  const bool has_chains =
      std::any_of(info.parameters.begin(), info.parameters.end(),
                  [](const ParameterSpec& spec) { return spec.name == "bootstrap"; });
  if (!has_chains) return {};
  return {{"bootstrap", "20000"}};
}

/// Raw sums of a render on so many threads.
std::vector<std::int64_t> sums(const Scene& scene, const IntegratorInfo& info, int threads) {
  RenderSettings settings;
  settings.resolution = scene.camera().resolution();
  settings.crop = Box2i(Vec2i(0, 0), settings.resolution - Vec2i(1, 1));
  settings.max_depth = 6;
  settings.seed = 7;
  settings.aovs = {"albedo", "depth", "object-id"};
  const auto integrator =
      info.make(scene, settings, Parameters(info.parameters, quick_parameters(info)));
  prepare(*integrator);
  Film film(settings.resolution, settings.crop, make_filter(scene.film().filter),
            settings.replicates, integrator->layers());
  RenderJobOptions options;
  options.budget.samples_per_pixel = 12;
  options.threads = threads;
  RenderJob(*integrator, film, options).run();
  return {film.raw().begin(), film.raw().end()};
}

class SameBits : public ::testing::TestWithParam<test::SmallScene> {};

TEST_P(SameBits, OnAnyNumberOfThreads) {
  const auto scene = test::scene_from(GetParam().text);
  for (const IntegratorInfo& info : integrators()) {
    const std::vector<std::int64_t> one = sums(*scene, info, 1);
    for (const int threads : {2, 5}) {
      EXPECT_EQ(sums(*scene, info, threads), one) << info.name << ", " << threads << " threads";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameBits, ::testing::ValuesIn(test::small_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace ajar
