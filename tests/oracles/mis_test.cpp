#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "core/random.h"
#include "path/measure.h"
#include "path/recorder.h"
#include "support/render.h"
#include "support/small_scenes.h"
#include "transport/sources.h"

namespace ajar {
namespace {

/// Compares the MIS weight of each sampled path with the definition.
class CheckingRecorder final : public PathRecorder {
 public:
  using PathRecorder::PathRecorder;

  void record(const Path& path, const Contribution& contribution) override {
    ASSERT_TRUE(contribution.value.is_finite());
    const auto [s, t] = contribution.technique;
    if (contribution.technique.depth() == 1) {
      EXPECT_EQ(contribution.mis_weight, 1.0);
      return;
    }
    const double expected = mis_weight(scene(), settings(), path, contribution.technique);
    // Positions are floats: the rest are roundings of distances and cosines.
    EXPECT_NEAR(contribution.mis_weight, expected, 2e-3 + 2e-3 * expected)
        << "technique (" << s << ", " << t << ")";
    ++checked[{s, t}];
  }

  std::map<std::pair<int, int>, int> checked;
};

class MisWeights : public ::testing::TestWithParam<test::SmallScene> {
 protected:
  /// Random camera samples, all over the film, until the sink has failed.
  static void sample(const Scene& scene, PathSampler& sampler, PathRecorder& sink,
                     std::uint32_t samples, bool light_alone = false) {
    const Vec2 size(scene.camera().resolution());
    for (std::uint32_t i = 0; i < samples && !HasFailure(); ++i) {
      IndependentSource source({1, i, 2, i});
      const Vec2 raster = source.get_pair({Stream::Camera, 0, kEmissionDirection}) * size;
      sink.begin(raster);
      if (light_alone) sampler.sample_light(source, sink);
      sampler.sample(source, raster, sink);
    }
  }
};

TEST_P(MisWeights, EqualTheSlowOracleOnRandomPaths) {
  const auto scene = test::scene_from(GetParam().text);
  for (const char* techniques :
       {"pt", "lt", "ibpt", "bdpt", "implicit,light", "implicit,explicit*3,light*0.5,inner*0.25",
        "(0,*),(1,3),(2,1)*0.5,(2,*),(3,2)*0.75,(*,1)"}) {
    const TechniqueSet set = TechniqueSet::parse(techniques);
    for (const Heuristic heuristic : {Heuristic::Balance, Heuristic::Power}) {
      PathSamplerSettings settings;
      settings.techniques = set;
      settings.heuristic = heuristic;
      settings.max_depth = 7;
      settings.light_subpaths = 1.5;
      settings.light_paths_per_pixel = 0.5;
      PathSampler sampler(*scene, settings);
      CheckingRecorder sink(*scene, settings);
      sample(*scene, sampler, sink, 600, !set.any(TechniqueClass::Inner));
      if (HasFailure()) return;
      EXPECT_EQ(sink.lost(), 0U);
      EXPECT_FALSE(sink.checked.empty()) << "no path was checked";
    }
  }
}

/// Compares the shares of classes with the sums of all their techniques' MIS weights.
class CheckingShares final : public PathRecorder {
 public:
  using PathRecorder::PathRecorder;

  void record(const Path& path, const Contribution& contribution) override {
    ByTechniqueClass<double> expected{};
    const int depth = contribution.technique.depth();
    for (int s = 0; s <= depth; ++s) {
      const Technique technique{s, depth + 1 - s};
      if (!settings().techniques.enabled(technique)) continue;
      expected[index_of(class_of(technique))] += mis_weight(scene(), settings(), path, technique);
    }
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(static_cast<double>(contribution.shares[k]), expected[k],
                  2e-3 + 2e-3 * expected[k])
          << name_of(static_cast<TechniqueClass>(k)) << ", depth " << depth;
    }
    ++checked[index_of(class_of(contribution.technique))];
  }

  ByTechniqueClass<int> checked{};
};

TEST_P(MisWeights, OfClassesAreThoseOfTheirTechniques) {
  const auto scene = test::scene_from(GetParam().text);
  // Paths of any depth, and of one: other coefficients, and other paths that leave the scene.
  for (const int min_depth : {1, 4}) {
    for (const Heuristic heuristic : {Heuristic::Balance, Heuristic::Power}) {
      PathSamplerSettings settings;
      settings.techniques = TechniqueSet::bdpt();
      settings.heuristic = heuristic;
      settings.min_depth = min_depth;
      settings.max_depth = min_depth == 1 ? 6 : min_depth;
      settings.shares_by_class = true;
      PathSampler sampler(*scene, settings);
      CheckingShares sink(*scene, settings);
      sample(*scene, sampler, sink, 200);
      if (HasFailure()) return;
      const int checked = std::accumulate(sink.checked.begin(), sink.checked.end(), 0);
      EXPECT_TRUE(checked > 0 || min_depth > 1);
    }
  }
}

/// Path tracing by the same numbers has the rays that are left of those of all techniques.
TEST_P(MisWeights, RaysAreCountedByUse) {
  const auto scene = test::scene_from(GetParam().text);
  PathSamplerSettings settings;
  settings.max_depth = 6;
  PathSampler by_path_tracing(*scene, settings);
  CheckingRecorder of_path_tracing(*scene, settings);
  sample(*scene, by_path_tracing, of_path_tracing, 200);
  settings.techniques = TechniqueSet::bdpt();
  PathSampler by_all(*scene, settings);
  CheckingRecorder of_all(*scene, settings);
  sample(*scene, by_all, of_all, 200);
  const RaysByUse& use = by_all.rays_by_use();
  const std::uint64_t to_lens = use.connections[index_of(TechniqueClass::Light)];
  const std::uint64_t inner = use.connections[index_of(TechniqueClass::Inner)];
  EXPECT_EQ(by_all.rays() - use.light_walk - to_lens - inner, by_path_tracing.rays());
  EXPECT_EQ(use.connections[index_of(TechniqueClass::NextEvent)],
            by_path_tracing.rays_by_use().connections[index_of(TechniqueClass::NextEvent)]);
}

INSTANTIATE_TEST_SUITE_P(Scenes, MisWeights, ::testing::ValuesIn(test::small_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace ajar
