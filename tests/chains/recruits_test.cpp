#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "integrator/selective/chain_bootstrap.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_recruits.h"
#include "integrator/selective/path_numbers.h"
#include "mcmc/moments.h"
#include "mcmc/primary/chain_source.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// Paths found by ordinary Monte Carlo must be reproduced as states of a chain, with the other
/// half's complement as weight: else both halves together are not the picture.
namespace ajar {
namespace {

struct Setting {
  std::string techniques;
  std::string light_paths;
};

/// Starts a chain at each path that is found, and compares.
class Comparison final : public StrongPathSinks {
 public:
  Comparison(const ChainPlan& plan, double light_paths) : plan_(plan), light_paths_(light_paths) {}
  std::unique_ptr<StrongPathSink> make(Film& /*film*/, Counters& /*counters*/) const override {
    return std::make_unique<Sink>(*this);
  }
  mutable int found = 0;
  mutable int found_by_later_subpaths = 0;
  mutable int different = 0;

 private:
  class Sink final : public StrongPathSink {
   public:
    explicit Sink(const Comparison& all) : all_(all) {}
    bool spread(SampleSource& numbers, StrongPath& path) override {
      ++all_.found;
      if (path.light_subpath > 0) ++all_.found_by_later_subpaths;
      const PathGroup& group = all_.plan_.group_of(path.technique.depth());
      const PrimaryChain chain = PathNumbers(numbers, path).start_chain(all_.plan_, group, path);
      const auto target = all_.plan_.make_target(group, path.replicate);
      ReplaySource replay(chain.numbers);
      SplatBuffer splats;
      const double scalar = target->evaluate(replay, Change{}, splats);
      EXPECT_EQ(target->technique()->technique, path.technique);
      double expected = static_cast<double>(
          path.strength *
          Division::above(path.strength, static_cast<float>(all_.plan_.lowest_threshold())));
      if (path.technique.s >= 2) expected *= all_.light_paths_;
      // Chains look over a larger area where filters reach beyond the film.
      if (path.technique.t == 1) expected *= all_.plan_.view.pixels / all_.plan_.view.area();
      expected /= static_cast<double>(target->technique()->probability);
      if (!(std::abs(scalar - expected) <= 0.01 * expected)) ++all_.different;
      return true;
    }

   private:
    const Comparison& all_;
  };
  const ChainPlan& plan_;
  double light_paths_;
};

TEST(Recruits, AreStatesOfChainsWithTheirWeight) {
  for (const char* name : {"Room", "GlassAndMetal"}) {
    const auto scene = test::scene_from(test::small_scene(name).text);
    for (const Setting& setting : {Setting{"bdpt", "1"}, Setting{"bdpt", "0.3"},
                                   Setting{"bdpt", "4"}, Setting{"ibpt", "0.33"}}) {
      const Parameters parameters(chain_parameters(ChainKind::OnePath),
                                  {{"techniques", setting.techniques},
                                   {"light-paths-per-pixel", setting.light_paths},
                                   {"importance", "uniform"},
                                   {"split", "0.1"}});
      ChainPlan plan(ChainKind::OnePath, *scene,
                     test::settings_of(*scene, {.replicates = 1, .max_depth = 6}), parameters);
      plan.brightness = 1.0;
      plan.divisions.emplace(Division(plan.lowest_threshold(), plan.view.importance));
      const Comparison comparison(plan, std::stod(setting.light_paths));
      const auto omc = plan.make_omc(plan.settings, plan.omc_depths(),
                                     {.divisions = &*plan.divisions, .strong = &comparison});
      Film film(plan.settings.resolution, plan.settings.crop, Filter::box(), 1, omc->layers());
      Counters counters;
      for (std::uint64_t item = 0; item < omc->items_in_round(); ++item) {
        omc->run_item(item, 0, 8, film, counters);
      }
      const std::string what = std::string(name) + ", " + setting.techniques + ", " +
                               setting.light_paths + " light subpaths";
      EXPECT_GT(comparison.found, 500) << what;
      // Rounding moves a path off an edge now and then.
      EXPECT_LT(comparison.different, comparison.found / 200) << what;
      EXPECT_EQ(comparison.found_by_later_subpaths > 100, setting.light_paths == "4") << what;
    }
  }
}

/// A lamp so small, over water, that unidirectional hits find about as much of the light through
/// the water as a few manifold connections do.
std::string small_lamp_over_water() {
  return test::pbrt_scene(
      "LookAt 0 2.4 -2.2  0 0 0.1  0 1 0\nCamera \"perspective\" \"float fov\" [40]", 48, 32,
      R"(AttributeBegin
  AreaLightSource "diffuse" "rgb L" [20 17.5 15]
  Shape "trianglemesh" "point P" [-0.16 1.9 -0.16  0.16 1.9 -0.16  0.16 1.9 0.16  -0.16 1.9 0.16]
    "integer indices" [0 1 2 0 2 3] "normal N" [0 -1 0  0 -1 0  0 -1 0  0 -1 0]
AttributeEnd
Material "matte" "rgb Kd" [0.7 0.6 0.5]
Shape "trianglemesh" "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] "integer indices" [0 2 1 0 3 2]
Material "glass" "float index" [1.33]
Shape "trianglemesh" "point P" [-2 0.5 -2  2 0.5 -2  2 0.6 2  -2 0.4 2] "integer indices" [0 2 1 0 3 2]
)");
}

/// Camera samples and manifold connections together agree with the bootstrap of `mlt`, which tries
/// connections eight times as often: hits that were counted whole, or a wrong number of tries,
/// would show.
TEST(Recruits, ShareUnconnectablePathsWithManifoldConnections) {
  const auto scene = test::scene_from(small_lamp_over_water());
  Moments all;
  Moments hits;
  Moments expected;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    ChainPlan plan(
        ChainKind::ExplicitPath, *scene,
        test::settings_of(*scene, {.replicates = 1, .seed = seed, .min_depth = 4, .max_depth = 4}),
        Parameters(chain_parameters(ChainKind::ExplicitPath), {{"split", "0.1"}}));
    plan.brightness = 0.03;  // brightness of the picture, as it is
    plan.divisions.emplace(Division(plan.lowest_threshold(), plan.view.importance));
    constexpr std::uint64_t kPerPixel = 128;
    const double camera_samples = static_cast<double>(kPerPixel * plan.pixels());
    ChainRecruits recruits(plan);
    recruits.expect_unknown(static_cast<double>(kPerPixel));
    const auto omc = plan.make_omc(plan.settings, plan.omc_depths(),
                                   {.divisions = &*plan.divisions, .strong = &recruits});
    Film film(plan.settings.resolution, plan.settings.crop, Filter::box(), 1, omc->layers());
    Counters counters;
    for (std::uint64_t item = 0; item < omc->items_in_round(); ++item) {
      omc->run_item(item, 0, kPerPixel, film, counters);
    }
    hits.add(recruits.energy() / camera_samples / plan.view.area_per_pixel());
    std::vector<ChainPopulation> populations = make_populations(plan);
    recruits.join(populations, 0, kPerPixel);
    double b = 0.0;
    double by_bootstrap = 0.0;
    for (ChainPopulation& population : populations) {
      b += population.b(0.0);
      const auto target = plan.make_seed_target(plan.groups[population.group], 0);
      Moments weights;
      std::vector<double> of_samples(4096);
      sample_bootstrap(*target, population.seed, 0, of_samples.size(), of_samples);
      for (const double weight : of_samples) weights.add(weight);
      by_bootstrap += weights.mean();
    }
    all.add(b);
    expected.add(by_bootstrap);
  }
  const double error = std::hypot(all.standard_error(), expected.standard_error());
  EXPECT_NEAR(all.mean(), expected.mean(), 5.0 * error);
  // Power of the test: neither part is missing, or there twice.
  const double joined = all.mean() - hits.mean();
  EXPECT_LT(5.0 * error, std::min(hits.mean(), joined)) << "too noisy to notice";
}

/// Few chains would explore by luck, whatever the initial estimate of their effort.
TEST(Recruits, AreForManyChainsUnlessForFirefliesOnly) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  RenderSettings settings = test::settings_of(*scene, {.replicates = 4, .max_depth = 6});
  const auto chains_of = [&](Vec2i resolution, double mutations, bool standby) {
    settings.resolution = resolution;
    settings.crop = Box2i(Vec2i(0, 0), resolution - Vec2i(1, 1));
    ChainPlan plan(ChainKind::OnePath, *scene, settings,
                   Parameters(chain_parameters(ChainKind::OnePath), {}));
    plan.mutations = mutations;
    plan.standby = standby;
    return plan.chains_per_replicate();
  };
  EXPECT_EQ(chains_of(Vec2i(128, 96), 0.1, false), 64U) << "144 steps each for 3 per pixel";
  EXPECT_EQ(chains_of(Vec2i(128, 96), 16.0, false), 341U);
  EXPECT_EQ(chains_of(Vec2i(128, 96), 0.03, true), 32U);
  EXPECT_EQ(chains_of(Vec2i(3840, 2160), 0.03, false), 8192U) << "memory";
}

}  // namespace
}  // namespace ajar
