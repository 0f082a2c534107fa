#include "integrator/metropolis/divided_path_weight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/random.h"
#include "integrator/division.h"
#include "integrator/metropolis/path_target.h"
#include "mcmc/counter_random.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/measure.h"
#include "path/recorder.h"
#include "support/render.h"
#include "support/small_scenes.h"
#include "transport/sources.h"

/// Part of a path that chains of explicit paths make: the sum over all techniques of the parts that
/// each leaves, by an image of thresholds and weights.
namespace ajar {
namespace {

struct Found {
  Path path;
  Technique technique;
  bool unidirectional_only;
  double light;  ///< luminance, MIS weight in it
};

class Collector final : public PathRecorder {
 public:
  using PathRecorder::PathRecorder;
  void record(const Path& path, const Contribution& contribution) override {
    if (!Division::divides(contribution.technique)) return;
    const auto light =
        static_cast<double>(luminance(contribution.value) / contribution.roulette_weight);
    if (light > 0.0)
      found.push_back({path, contribution.technique, contribution.unidirectional_only, light});
  }
  std::vector<Found> found;
};

PathSamplerSettings settings_of(const std::string& techniques, Heuristic heuristic) {
  PathSamplerSettings settings;
  settings.techniques = TechniqueSet::parse(techniques);
  settings.heuristic = heuristic;
  settings.max_depth = 6;
  settings.roulette_start = 7;
  return settings;
}

std::vector<Found> found_in(const Scene& scene, const PathSamplerSettings& settings) {
  PathSampler sampler(scene, settings);
  Collector collector(scene, settings);
  const Vec2 size(scene.camera().resolution());
  for (std::uint32_t i = 0; i < 2000; ++i) {
    IndependentSource source({3, i, 4, i});
    const Vec2 raster = source.get_pair({Stream::Camera, 0, kEmissionDirection}) * size;
    collector.begin(raster);
    sampler.sample(source, raster, collector);
  }
  return std::move(collector.found);
}

/// Another one in every pixel, some of them 0.
Division random_division(const Box2i& crop, const ImportanceMap& importance) {
  const Vec2i size = crop.size() + Vec2i(1, 1);
  std::vector<PixelDivision> shares(static_cast<std::size_t>(size.x) *
                                    static_cast<std::size_t>(size.y));
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const auto number = [&](std::uint64_t n) {
      return static_cast<float>(to_unit_double(hash_numbers(11, i, n)));
    };
    shares[i].threshold = number(0) < 0.2F ? 0.F : number(1);
    shares[i].target_scale = number(2) < 0.2F ? 0.F : number(3);
  }
  return {crop, std::move(shares), importance};
}

double slow_share(const Scene& scene, const PathSamplerSettings& settings, const Path& path,
                  const Division& division) {
  const PixelDivision& share = division.at(path.raster);
  double sum = 0.0;
  for (int s = 0; s <= path.depth(); ++s) {
    const Technique technique{s, path.depth() + 1 - s};
    const double weight = mis_weight(scene, settings, path, technique);
    if (!(weight > 0.0)) continue;
    const double strength =
        weight * static_cast<double>(luminance(throughput(scene, path, technique))) /
        tries(settings, technique) * static_cast<double>(division.importance(path.raster));
    sum += weight * static_cast<double>(share.target_scale) * strength /
           (static_cast<double>(share.threshold) + strength);
  }
  return sum;
}

class PathShareOf : public ::testing::TestWithParam<test::SmallScene> {};

TEST_P(PathShareOf, IsTheSumOverAllTechniques) {
  const auto scene = test::scene_from(GetParam().text);
  const Vec2i size = scene->camera().resolution();
  const Box2i all(Vec2i(0, 0), size - Vec2i(1, 1));
  std::vector<float> weights(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = 0.2F + static_cast<float>(to_unit_double(hash_numbers(12, i)));
  }
  const ImportanceMap importance(all, weights);
  const Division division = random_division(all, importance);
  for (const char* techniques : {"bdpt", "ibpt"}) {
    for (const Heuristic heuristic : {Heuristic::Power, Heuristic::Balance}) {
      const PathSamplerSettings settings = settings_of(techniques, heuristic);
      DividedPathWeight share(*scene, settings, importance, &division);
      DividedPathWeight whole(*scene, settings, importance, nullptr);
      DividedPathWeight connectible(*scene, settings, importance, nullptr, PathClass::Connectible);
      DividedPathWeight hit(*scene, settings, importance, nullptr, PathClass::UnidirectionalOnly);
      TechniqueParts parts(*scene, settings);
      std::size_t different = 0;
      std::size_t by_several = 0;
      std::size_t hit_only_ones = 0;
      const std::vector<Found> found = found_in(*scene, settings);
      for (const auto& [path, technique, unidirectional_only, light] : found) {
        const double log_light = contribution(*scene, path).log_luminance();
        const double slow = slow_share(*scene, settings, path, division);
        ASSERT_NEAR(share.part(path, log_light), slow, 1e-4 * slow + 1e-12);
        ASSERT_NEAR(whole.part(path, log_light), 1.0, 1e-9);
        // The class of a path is independent of the chain that asks.
        ASSERT_NEAR(hit.part(path, log_light), unidirectional_only ? 1.0 : 0.0, 1e-9);
        ASSERT_NEAR(connectible.part(path, log_light), unidirectional_only ? 0.0 : 1.0, 1e-9);
        ASSERT_TRUE(!unidirectional_only || technique.s == 0);
        hit_only_ones += unidirectional_only ? 1 : 0;
        // The remainder of the technique that found it is one of the terms.
        const double own = parts.of(path, log_light)[static_cast<std::size_t>(technique.s)].light;
        if (!(std::abs(own - light) <= 0.01 * light)) ++different;
        if (slow > 0.0 &&
            slow < 0.99 * static_cast<double>(division.at(path.raster).target_scale)) {
          ++by_several;
        }
      }
      EXPECT_GT(found.size(), 100U) << techniques;
      if (GetParam().name == "GlassAndMetal" || GetParam().name == "Environment") {
        EXPECT_GT(hit_only_ones, 0U);
      }
      EXPECT_GT(by_several, found.size() / 20) << techniques << ": nothing is divided";
      // Rounding moves a path off an edge now and then.
      EXPECT_LE(different, found.size() / 100) << techniques;
    }
  }
}

/// Light of a state of numbers belongs to one of two classes of paths.
TEST(PathClasses, MakeAllOfAStateTogether) {
  const auto scene = test::scene_from(test::small_scene("Environment").text);
  const Vec2i size = scene->camera().resolution();
  ChainView view;
  view.size = Vec2(size);
  view.pixels = static_cast<double>(size.x) * static_cast<double>(size.y);
  PathSamplerSettings settings = settings_of("bdpt", Heuristic::Power);
  settings.min_depth = settings.max_depth = 3;
  const TechniqueChoice choice(settings.techniques, 3);
  const auto target_of = [&](PathClass paths) {
    return OnePathTarget(*scene, settings, choice, view, nullptr, paths);
  };
  OnePathTarget all = target_of(PathClass::All);
  OnePathTarget connectible = target_of(PathClass::Connectible);
  OnePathTarget unidirectional_only = target_of(PathClass::UnidirectionalOnly);
  std::size_t some_connectible = 0;
  std::size_t some_hit_only = 0;
  for (std::uint64_t i = 0; i < 50000; ++i) {
    const auto evaluate = [&](OnePathTarget& target) {
      BootstrapSource numbers(5, i);
      SplatBuffer splats;
      const double scalar = target.evaluate(numbers, Change{}, splats);
      target.rejected();
      return scalar;
    };
    const double whole = evaluate(all);
    const double of_connectible = evaluate(connectible);
    const double of_hit_only = evaluate(unidirectional_only);
    ASSERT_EQ(of_connectible + of_hit_only, whole);
    if (of_connectible > 0.0) ++some_connectible;
    if (of_hit_only > 0.0) ++some_hit_only;
  }
  EXPECT_GT(some_connectible, 1000U);
  EXPECT_GT(some_hit_only, 10U);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PathShareOf, ::testing::ValuesIn(test::small_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace ajar
