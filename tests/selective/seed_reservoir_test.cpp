#include "integrator/selective/seed_reservoir.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "integrator/selective/path_numbers.h"
#include "integrator/selective/preparation.h"
#include "mcmc/moments.h"
#include "mcmc/primary/chain_source.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// A path that ordinary Monte Carlo has found must be the same path as the state of a chain, of the
/// value that ordinary Monte Carlo leaves of it: else both halves together are not the picture.
namespace ajar {
namespace {

struct Setting {
  std::string techniques;
  std::string light_paths;
};

/// Starts a chain at each path that is found, and compares.
class Comparison final : public OutlierSinkFactory {
 public:
  Comparison(const SelectivePreparation& prepared, double light_paths)
      : prepared_(prepared), light_paths_(light_paths) {}
  std::unique_ptr<OutlierSink> make(Film& /*film*/, Counters& /*counters*/) const override {
    return std::make_unique<Sink>(*this);
  }
  mutable int found = 0;
  mutable int found_by_later_subpaths = 0;
  mutable int different = 0;

 private:
  class Sink final : public OutlierSink {
   public:
    explicit Sink(const Comparison& all) : all_(all) {}
    bool spread(SampleSource& numbers, OutlierPath& path) override {
      ++all_.found;
      if (path.light_subpath > 0) ++all_.found_by_later_subpaths;
      const PathGroup& group = all_.prepared_.group_of(path.technique.depth());
      const PrimaryChain chain =
          PathNumbers(numbers, path).start_chain(all_.prepared_, group, path);
      const auto target = make_path_target(all_.prepared_.problem(group, path.replicate));
      ReplaySource replay(chain.numbers);
      SplatBuffer splats;
      const double scalar = target->evaluate(replay, Change{}, splats);
      EXPECT_EQ(target->technique()->technique, path.technique);
      double expected = static_cast<double>(
          path.strength *
          Division::chain_fraction(path.strength,
                                   static_cast<float>(all_.prepared_.lowest_threshold())));
      if (path.technique.s >= 2) expected *= all_.light_paths_;
      // Chains look over a larger area where filters reach beyond the film.
      if (path.technique.t == 1)
        expected *= all_.prepared_.view.pixels / all_.prepared_.view.area();
      expected /= static_cast<double>(target->technique()->probability);
      if (!(std::abs(scalar - expected) <= 0.01 * expected)) ++all_.different;
      return true;
    }

   private:
    const Comparison& all_;
  };
  const SelectivePreparation& prepared_;
  double light_paths_;
};

std::unique_ptr<SelectivePreparation> prepared_for(const Scene& scene,
                                                   const RenderSettings& settings,
                                                   std::map<std::string, std::string> parameters,
                                                   double brightness) {
  parameters.insert({{"importance", "uniform"}, {"split", "0.1"}});
  auto prepared = std::make_unique<SelectivePreparation>(
      SelectiveConfig(scene, settings, Parameters(SelectiveConfig::parameters(), parameters)));
  prepared->brightness = brightness;
  prepared->divisions.emplace(Division(prepared->lowest_threshold(), prepared->view.importance));
  return prepared;
}

std::unique_ptr<Integrator> omc_of(const SelectivePreparation& prepared,
                                   const OutlierSinkFactory& sinks) {
  return prepared.make_omc(prepared.techniques.omc, prepared.config.settings,
                           {.divisions = &*prepared.divisions, .strong = &sinks});
}

Film film_of(const SelectivePreparation& prepared, const Integrator& omc) {
  const RenderSettings& settings = prepared.config.settings;
  return {settings.resolution, settings.crop, Filter::box(), 1, omc.layers()};
}

TEST(SeedReservoir, FindsAreStatesOfChainsOfTheSameValue) {
  for (const char* name : {"Room", "GlassAndMetal"}) {
    const auto scene = test::scene_from(test::small_scene(name).text);
    for (const Setting& setting : {Setting{"bdpt", "1"}, Setting{"bdpt", "0.3"},
                                   Setting{"bdpt", "4"}, Setting{"ibpt", "0.33"}}) {
      const auto prepared =
          prepared_for(*scene, test::settings_of(*scene, {.replicates = 1, .max_depth = 6}),
                       {{"chain", "mmlt"},
                        {"techniques", setting.techniques},
                        {"light-paths-per-pixel", setting.light_paths}},
                       1.0);
      const Comparison comparison(*prepared, std::stod(setting.light_paths));
      const auto omc = omc_of(*prepared, comparison);
      Film film = film_of(*prepared, *omc);
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

/// A lamp so small, over water, that running into it finds about as much of what is seen through
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

/// Camera samples and manifold connections together find as much light as the bootstrap of `mlt`
/// says, which tries connections eight times as often: hits that were counted whole, or tries by
/// another number, would show.
TEST(SeedReservoir, SharesWhatNoConnectionMakesWithManifoldConnections) {
  const auto scene = test::scene_from(small_lamp_over_water());
  Moments all;
  Moments hits;
  Moments expected;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto prepared = prepared_for(
        *scene,
        test::settings_of(*scene, {.replicates = 1, .seed = seed, .min_depth = 4, .max_depth = 4}),
        {{"chain", "mlt"}, {"techniques", "bdpt"}}, 0.03);  // about the brightness of the picture
    constexpr std::uint64_t kPerPixel = 128;
    const double camera_samples = static_cast<double>(kPerPixel * prepared->pixels());
    SeedReservoir reservoir(*prepared);
    reservoir.set_initial_rate(static_cast<double>(kPerPixel));
    const auto omc = omc_of(*prepared, reservoir);
    Film film = film_of(*prepared, *omc);
    Counters counters;
    for (std::uint64_t item = 0; item < omc->items_in_round(); ++item) {
      omc->run_item(item, 0, kPerPixel, film, counters);
    }
    hits.add(reservoir.energy() / camera_samples / prepared->view.area_per_pixel());
    std::vector<ChainPopulation> populations =
        make_populations<ChainPopulation>(prepared->groups(), 1, seed);
    reservoir.merge(populations, 0, kPerPixel);
    double b = 0.0;
    double by_bootstrap = 0.0;
    for (ChainPopulation& population : populations) {
      b += population.b.total;
      const auto target =
          make_seed_target(prepared->problem(prepared->groups()[population.group], 0));
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
  // Neither part may be missing, or there twice.
  const double joined = all.mean() - hits.mean();
  EXPECT_LT(5.0 * error, std::min(hits.mean(), joined)) << "too noisy to notice";
}

/// Each find starts as many chains as it stands for, and all of these walk equally far: one chain
/// with so many times the steps would be biased by its start-up.
TEST(SeedReservoir, BrightFindsStartManyChains) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  RenderSettings settings = test::settings_of(*scene, {.replicates = 1, .max_depth = 6});
  const auto prepared =
      prepared_for(*scene, settings, {{"chain", "mmlt"}, {"techniques", "bdpt"}}, 1.0);
  SeedReservoir reservoir(*prepared);
  reservoir.set_initial_rate(0.0);  // all are kept
  prepared->mutations = 1000.0;
  const auto omc = omc_of(*prepared, reservoir);
  Film film = film_of(*prepared, *omc);
  Counters counters;
  // One tile, whose few finds stand for all chains.
  omc->run_item(omc->items_in_round() / 2, 0, 1, film, counters);
  std::vector<ChainPopulation> populations =
      make_populations<ChainPopulation>(prepared->groups(), 1, 1);
  reservoir.merge(populations, 0, 1);
  std::size_t chains = 0;
  std::set<std::uint64_t> seeds;
  std::set<std::uint64_t> origins;
  for (const ChainPopulation& population : populations) {
    for (const SelectiveChain& chain : population.chains) {
      ++chains;
      EXPECT_EQ(std::abs(chain.weight), 1.0);
      seeds.insert(chain.chain().seed);
      origins.insert(chain.origin());
    }
  }
  EXPECT_GE(chains, prepared->chains_per_replicate());
  EXPECT_LT(origins.size(), chains) << "some start at the same path";
  EXPECT_EQ(seeds.size(), chains) << "each has randomness of its own";
}

/// Few chains leave what there is to explore to luck, whatever the first guess of their effort.
TEST(SeedReservoir, SeedsManyChainsUnlessTheyMakeFirefliesOnly) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  RenderSettings settings = test::settings_of(*scene, {.replicates = 4, .max_depth = 6});
  const auto chains_of = [&](Vec2i resolution, double mutations, bool fireflies_only) {
    settings.resolution = resolution;
    settings.crop = Box2i(Vec2i(0, 0), resolution - Vec2i(1, 1));
    const auto prepared = prepared_for(*scene, settings, {{"chain", "mmlt"}}, 1.0);
    prepared->mutations = mutations;
    prepared->fireflies_only = fireflies_only;
    return prepared->chains_per_replicate();
  };
  EXPECT_EQ(chains_of(Vec2i(128, 96), 0.1, false), 64U) << "144 steps each for 3 per pixel";
  EXPECT_EQ(chains_of(Vec2i(128, 96), 16.0, false), 341U);
  EXPECT_EQ(chains_of(Vec2i(128, 96), 0.03, true), 32U);
  EXPECT_EQ(chains_of(Vec2i(3840, 2160), 0.03, false), 8192U) << "memory";
}

}  // namespace
}  // namespace ajar
