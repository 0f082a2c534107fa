#include "integrator/metropolis/path_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mcmc/primary/bootstrap_source.h"
#include "mcmc/primary/chain_source.h"
#include "mcmc/primary/make_mutation.h"
#include "mcmc/primary/primary_chain.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// Targets over paths, on random sequences of moves.
namespace ajar {
namespace {

struct TargetCase {
  const char* scene;
  int depth;
  friend void PrintTo(const TargetCase& c, std::ostream* out) {
    *out << c.scene << ", " << c.depth;
  }
};
class HalfReuse : public ::testing::TestWithParam<TargetCase> {
 protected:
  HalfReuse() {
    for (const test::SmallScene& small : test::small_scenes()) {
      if (small.name == GetParam().scene) scene_ = test::scene_from(small.text);
    }
    settings_.techniques = TechniqueSet::bdpt();
    settings_.min_depth = GetParam().depth;
    settings_.max_depth = GetParam().depth;
    settings_.roulette_start = 1000;
    // A pixel beyond the film on each side, as wide filters have it.
    view_.low = Vec2(-1.F, -1.F);
    view_.size = Vec2(scene_->camera().resolution()) + Vec2(2.F, 2.F);
  }
  PrimaryShape shape() const { return {GetParam().depth + 1, GetParam().depth + 1}; }

  /// A chain that starts at the first bootstrap sample with light.
  PrimaryChain lit_chain(OnePathTarget& target) const {
    for (std::uint64_t i = 0;; ++i) {
      BootstrapSource source(5, i);
      SplatBuffer splats;
      const double scalar = target.evaluate(source, Change{}, splats);
      target.rejected();
      if (scalar > 0.0) return PrimaryChain(shape(), 6, bootstrap_key(5, i), scalar);
    }
  }

  std::unique_ptr<Scene> scene_;
  PathSamplerSettings settings_;
  ChainView view_;
};

/// Counts the directions that a target keeps.
class CountingSource final : public SampleSource {
 public:
  explicit CountingSource(ChainSource& source) : source_(source) {}
  float get(SampleAddress address) override { return source_.get(address); }
  Vec2 get_pair(SampleAddress address) override { return source_.get_pair(address); }
  void replace_pair(SampleAddress address, const Vec2& numbers, double log_density) override {
    EXPECT_EQ(address.stream(), Stream::Camera);
    EXPECT_EQ(address.slot(), Slot::BsdfDirectionX);
    ++replaced_;
    source_.replace_pair(address, numbers, log_density);
  }
  int replaced() const { return replaced_; }

 private:
  ChainSource& source_;
  int replaced_ = 0;
};

void expect_same_bits(const SplatBuffer& a, const SplatBuffer& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].layer, b[i].layer);
    EXPECT_EQ(a[i].raster.x, b[i].raster.x);
    EXPECT_EQ(a[i].raster.y, b[i].raster.y);
    for (int lane = 0; lane < 3; ++lane) EXPECT_EQ(a[i].value[lane], b[i].value[lane]);
  }
}

TEST_P(HalfReuse, GivesTheBitsOfATargetThatTracesEverything) {
  const TechniqueChoice choice(settings_.techniques, GetParam().depth);
  OnePathTarget target(*scene_, settings_, choice, view_);
  PrimaryChain chain = lit_chain(target);
  const auto mutation = make_mutation("kelemen", 0.01);
  ChainSource source(*mutation, StepSizes{}, shape());
  SplatBuffer splats;
  {
    ReplaySource replay(chain.numbers);
    ASSERT_EQ(target.evaluate(replay, Change{}, splats), chain.scalar);
    target.accepted();
    source.start(replay.uses_raster(), 1.F);
  }
  // Half moves mostly, as they are the subject, in any order and with any outcome.
  const StepProbabilities probabilities{
      .large = 0.1, .camera_half = 0.45, .light_half = 0.45, .raster = 0.3};
  std::uint64_t fewer_rays = 0;
  struct {
    int implicit = 0;
    int connected = 0;
  } kept;
  int lit = 0;
  constexpr int kSteps = 4000;
  for (int step = 0; step < kSteps && !HasFailure(); ++step) {
    SCOPED_TRACE(step);
    const std::uint64_t key = hash_numbers(7, step);
    const StepKind kind = probabilities.choose(to_unit_double(counter_bits(key, 0)));
    // Where the technique moves along with a half, the other half may be wanted in another length.
    const bool technique_moves = step % 2 == 1;
    const Change change = change_of(kind, {technique_moves, technique_moves}, source.uses_raster());
    source.propose(chain.numbers, kind, change, counter_bits(key, 1));
    splats.clear();
    const std::uint64_t rays_before = target.rays();
    CountingSource counting(source);
    const double scalar = target.evaluate(counting, change, splats);
    if (change.raster) {
      (target.technique()->technique.s == 0 ? kept.implicit : kept.connected) +=
          counting.replaced();
    } else {
      EXPECT_EQ(counting.replaced(), 0);
    }

    OnePathTarget fresh(*scene_, settings_, choice, view_);
    SplatBuffer expected;
    const double expected_scalar = fresh.evaluate(source, Change{}, expected);
    EXPECT_EQ(scalar, expected_scalar);
    EXPECT_EQ(target.technique()->number, fresh.technique()->number);
    expect_same_bits(splats, expected);
    EXPECT_LE(target.rays() - rays_before, fresh.rays());
    if (target.rays() - rays_before < fresh.rays()) ++fewer_rays;

    if (scalar > 0.0) ++lit;
    if (scalar > 0.0 && to_unit_double(counter_bits(key, 2)) < 0.5) {
      source.accept();
      target.accepted();
    } else {
      source.reject();
      target.rejected();
    }
  }
  EXPECT_GT(lit, kSteps / 20) << "too little light to say much";
  EXPECT_GT(fewer_rays, kSteps / 20U) << "halves are hardly ever reused";
  EXPECT_GT(kept.connected, 0);
  // Elsewhere hardly any camera path runs into a lamp.
  if (GetParam().scene == std::string("Environment")) {
    EXPECT_GT(kept.implicit, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, HalfReuse,
                         ::testing::Values(TargetCase{"Room", 3}, TargetCase{"Room", 6},
                                           TargetCase{"GlassAndMetal", 5},
                                           TargetCase{"ThinLens", 4}, TargetCase{"Environment", 4},
                                           TargetCase{"Fog", 4}, TargetCase{"MilkBall", 6},
                                           TargetCase{"EnvironmentCamera", 3}));

TEST(WholePathTarget, KeepsDirectionsInStepsOfTheRasterNumbersAlone) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  PathSamplerSettings settings;
  settings.techniques = TechniqueSet::bdpt();
  settings.max_depth = 5;
  ChainView view;
  view.size = Vec2(scene->camera().resolution());
  WholePathTarget target(*scene, settings, view);
  const PrimaryShape shape{6, 6};
  const auto mutation = make_mutation("gaussian", 0.01);
  ChainSource source(*mutation, StepSizes{}, shape);
  ChainNumbers numbers(shape, 8);
  const auto evaluate = [&](SampleSource& from, const Change& change) {
    SplatBuffer splats;
    const double scalar = target.evaluate(from, change, splats);
    target.accepted();
    return scalar;
  };
  source.propose(numbers, StepKind::SmallBoth, Change{}, 1);
  evaluate(source, Change{});
  source.accept();
  int kept = 0;
  for (std::uint64_t step = 0; step < 200; ++step) {
    const Change change = change_of(StepKind::SmallRaster, {}, true);
    source.propose(numbers, StepKind::SmallRaster, change, 2 + step);
    CountingSource counting(source);
    const double scalar = evaluate(counting, change);
    kept += counting.replaced();
    source.accept();
    ReplaySource replay(numbers);
    EXPECT_EQ(evaluate(replay, Change{}), scalar);
  }
  EXPECT_GT(kept, 50);
}

TEST(ChainOfPaths, OfSixteenEdgesFitsInFourKibibytes) {
  constexpr int kDepth = 16;
  const auto scene = test::scene_from(test::small_scenes().front().text);
  PathSamplerSettings settings;
  settings.techniques = TechniqueSet::bdpt();
  settings.min_depth = kDepth;
  settings.max_depth = kDepth;
  const TechniqueChoice choice(settings.techniques, kDepth);
  ChainView view;
  view.size = Vec2(scene->camera().resolution());
  OnePathTarget target(*scene, settings, choice, view);
  const PrimaryShape shape{kDepth + 1, kDepth + 1};
  PrimaryChain chain(shape, 1, bootstrap_key(5, 0), 1.0);
  const auto mutation = make_mutation("kelemen", 0.01);
  ChainSource source(*mutation, StepSizes{}, shape);
  for (int step = 0; step < 500; ++step) {
    SplatBuffer splats;
    source.propose(chain.numbers, step % 3 == 0 ? StepKind::Large : StepKind::SmallBoth, Change{},
                   hash_numbers(9, step));
    target.evaluate(source, Change{}, splats);
    source.accept();
    target.accepted();
  }
  EXPECT_LE(chain.memory_bytes(), 4096U);
}

}  // namespace
}  // namespace ajar
