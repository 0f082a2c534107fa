#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "session/job/preparation.h"
#include "session/job/render_job.h"
#include "session/render/resolved_render.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar {
namespace {

/// Raw sums of a render on so many threads: three passes of four samples per pixel.
std::vector<std::int64_t> sums(const Scene& scene, const IntegratorInfo& info, int threads,
                               const std::vector<std::string>& aovs,
                               const std::map<std::string, std::string>& parameters) {
  RenderSettings settings = settings_for(scene);
  settings.max_depth = 6;
  settings.seed = 7;
  settings.aovs = aovs;
  const auto integrator = info.make(scene, settings, info.read(parameters));
  prepare(*integrator);
  Film film = film_for(scene, settings, *integrator);
  RenderJobOptions options;
  options.budget.samples_per_pixel = 12;
  options.threads = threads;
  const RenderResult result = RenderJob(*integrator, film, options).run();
  EXPECT_GE(result.passes, 3U) << "chains carry something from pass to pass";
  return {film.raw().begin(), film.raw().end()};
}

/// Scenes take turns in the second number of threads, so that each method has every number.
class SameBits : public ::testing::TestWithParam<test::SmallScene> {
 protected:
  int threads() const {
    int number = 0;
    for (const test::SmallScene& scene : test::small_scenes()) {
      if (scene.name == GetParam().name) break;
      ++number;
    }
    return number % 2 == 0 ? 5 : 2;
  }
};

TEST_P(SameBits, OnAnyNumberOfThreads) {
  const auto scene = test::scene_from(GetParam().text);
  for (const IntegratorInfo& info : integrators()) {
    // The default bootstrap takes longer than all the rest.
    std::map<std::string, std::string> parameters;
    if (info.name.ends_with("mlt") || info.name == "erpt" || info.name == "masked") {
      parameters["bootstrap"] = "10000";
    }
    std::vector<std::string> aovs = {"albedo", "depth", "object-id"};
    if (info.name == "selective") aovs.emplace_back("density");
    const std::vector<std::int64_t> one = sums(*scene, info, 1, aovs, parameters);
    EXPECT_EQ(sums(*scene, info, threads(), aovs, parameters), one)
        << info.name << ", " << threads() << " threads";
  }
}

/// Rounds of roulette end at 4 and 8 samples per pixel.
TEST_P(SameBits, OfEfficientRouletteOnAnyNumberOfThreads) {
  const auto scene = test::scene_from(GetParam().text);
  const IntegratorInfo& info = find_integrator("bdpt");
  const std::map<std::string, std::string> parameters = {{"roulette", "efficient"}};
  const std::vector<std::int64_t> one = sums(*scene, info, 1, {}, parameters);
  EXPECT_EQ(sums(*scene, info, threads(), {}, parameters), one);
  EXPECT_NE(sums(*scene, info, 1, {}, {}), one) << "it has done nothing";
}

/// Chains with their options, on scenes that differ in film, camera and media.
class OptionsSameBits : public SameBits {};

TEST_P(OptionsSameBits, OfChainsWithAllTheirOptionsOnAnyNumberOfThreads) {
  const auto scene = test::scene_from(GetParam().text);
  for (const char* name : {"mmlt", "pssmlt"}) {
    const IntegratorInfo& info = find_integrator(name);
    const std::vector<std::string> aovs = {"density", "acceptance", "albedo"};
    // So few bootstrap samples that some populations have no chains.
    std::map<std::string, std::string> parameters = {
        {"mis-large-steps", "true"}, {"mutation", "gaussian"}, {"bootstrap", "1500"}};
    if (info.name == "mmlt") parameters.insert({{"camera-steps", "0.2"}, {"light-steps", "0.2"}});
    const std::vector<std::int64_t> one = sums(*scene, info, 1, aovs, parameters);
    EXPECT_EQ(sums(*scene, info, threads(), aovs, parameters), one)
        << name << ", " << threads() << " threads";
  }
}

TEST_P(OptionsSameBits, OfChainsOfExplicitPathsOnAnyNumberOfThreads) {
  const auto scene = test::scene_from(GetParam().text);
  const IntegratorInfo& info = find_integrator("selective");
  using Settings = std::map<std::string, std::string>;
  for (const Settings& parameters : {Settings{{"chain", "auto"}, {"split", "0.1"}},
                                     Settings{{"chain", "mlt"}, {"split", "0.3"}}}) {
    const std::vector<std::int64_t> one = sums(*scene, info, 1, {"density"}, parameters);
    EXPECT_EQ(sums(*scene, info, threads(), {"density"}, parameters), one)
        << parameters.begin()->second << ", " << threads() << " threads";
  }
}

TEST_P(OptionsSameBits, OfEnergyRedistributionByNumbersOnAnyNumberOfThreads) {
  const auto scene = test::scene_from(GetParam().text);
  const IntegratorInfo& info = find_integrator("erpt");
  const std::map<std::string, std::string> parameters = {{"chain", "pssmlt"},
                                                         {"bootstrap", "3000"}};
  const std::vector<std::int64_t> one = sums(*scene, info, 1, {"density"}, parameters);
  EXPECT_EQ(sums(*scene, info, threads(), {"density"}, parameters), one) << threads() << " threads";
}

TEST_P(OptionsSameBits, OfChainsThatFollowTheImagePlaneOnAnyNumberOfThreads) {
  const auto scene = test::scene_from(GetParam().text);
  const IntegratorInfo& info = find_integrator("mmlt");
  // Thresholds that are passed after the first of three passes.
  const std::map<std::string, std::string> common = {
      {"bootstrap", "3000"}, {"m1", "2"}, {"w", "4"}, {"k1", "20"}};
  std::vector<std::map<std::string, std::string>> variants = {
      {{"mutation", "fusion"}},
      {{"mutation", "fusion"}, {"rule", "published"}},
      {{"multi-try", "3"}, {"seeds", "filtered"}}};
  for (auto& parameters : variants) {
    parameters.insert(common.begin(), common.end());
    const std::vector<std::int64_t> one = sums(*scene, info, 1, {"density"}, parameters);
    EXPECT_EQ(sums(*scene, info, threads(), {"density"}, parameters), one)
        << parameters.begin()->second << ", " << threads() << " threads";
  }
}

std::vector<test::SmallScene> scenes_for_options() {
  std::vector<test::SmallScene> scenes;
  for (const char* name :
       {"Room", "CroppedMitchell", "Fog", "ThinLens", "Environment", "NestedDielectrics"}) {
    scenes.push_back(test::small_scene(name));
  }
  return scenes;
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameBits, ::testing::ValuesIn(test::small_scenes()),
                         [](const auto& test) { return test.param.name; });
INSTANTIATE_TEST_SUITE_P(Scenes, OptionsSameBits, ::testing::ValuesIn(scenes_for_options()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace ajar
