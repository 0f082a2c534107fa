#include "integrator/selective/region_choice.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

#include "integrator/montecarlo/weighted_errors.h"
#include "integrator/selective/chain_fraction.h"
#include "integrator/selective/heuristics.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// Decisions from the few samples of a pilot.
namespace ajar {
namespace {

/// A picture of which two replicates have seen even noise alone, so that bad chains would only
/// cost.
class RegionChoiceTest : public ::testing::Test {
 protected:
  static constexpr double kBrightness = 1.0;
  static constexpr std::uint64_t kSamples = 4;

  RegionChoiceTest()
      : scene_(test::scene_from(test::small_scene("Room").text)),
        settings_(test::settings_of(*scene_, {.replicates = 2, .max_depth = 6})),
        prepared_(config()) {
    prepared_.brightness = kBrightness;
    prepared_.divisions.emplace(Division(0.0, prepared_.view.importance));
    omc_ = prepared_.make_omc(prepared_.techniques.omc, settings_,
                              {.divisions = &*prepared_.divisions});
    film_ = std::make_unique<Film>(settings_.resolution, settings_.crop, Filter::box(), 2,
                                   omc_->layers());
    const Vec2i size = settings_.crop.size() + Vec2i(1, 1);
    prepared_.surfaces.regions =
        connected_regions(size, std::vector<PixelIdentity>(prepared_.pixels()));
    std::mt19937 random(5);
    std::exponential_distribution<float> light(1.F / static_cast<float>(kBrightness));
    for (std::uint64_t i = 0; i < prepared_.pixels() * kSamples; ++i) {
      found_.push_back(path(i, light(random)));
      film_->splat(film_->layer(kWeakLayer), static_cast<int>(i % 2), found_.back().raster,
                   Spectrum(light(random)));
    }
  }

  SelectiveConfig config() const {
    return {
        *scene_, settings_,
        Parameters(SelectiveConfig::parameters(), {{"chain", "mmlt"}, {"importance", "uniform"}})};
  }

  /// The only path of its sample.
  PilotPath path(std::uint64_t sample, float energy) const {
    const std::uint64_t pixel = sample / kSamples;
    const auto width = static_cast<std::uint64_t>(prepared_.surfaces.regions.size.x);
    return {.sample = sample,
            .raster = Vec2(static_cast<float>(pixel % width) + 0.5F,
                           static_cast<float>(pixel / width) + 0.5F),
            .value = Spectrum(energy),
            .strength = energy,
            .energy = energy,
            .weight = 1.F,
            .replicate = static_cast<std::int16_t>(sample % 2),
            .s = 2,
            .t = 2};
  }

  PilotView view(double correlation) const {
    return {prepared_, *film_, *omc_, kSamples, 10.0, found_, {0, 1}, correlation};
  }
  RegionChoice choose(double correlation) const { return choose_regions(view(correlation)); }
  /// T of the first region.
  double threshold(double correlation) const {
    return static_cast<double>(choose(correlation).regions.front().threshold);
  }

  std::unique_ptr<Scene> scene_;
  RenderSettings settings_;
  SelectivePreparation prepared_;
  std::unique_ptr<Integrator> omc_;
  std::unique_ptr<Film> film_;
  std::vector<PilotPath> found_;
};

TEST_F(RegionChoiceTest, AFireflyIsDifficultLightInItsCellAlone) {
  const Vec2i cells = (prepared_.surfaces.regions.size + Vec2i(15, 15)) / 16;
  const double of_cell = 1.0 / (cells.x * cells.y);
  const auto share = [&](double threshold) {
    return chain_fraction(view(10.0), Divisions(Division(threshold, prepared_.view.importance)));
  };
  // Found light that is not on the film: about half of all, to which T leaves some.
  EXPECT_GT(share(0.1), share(3.0));
  found_.clear();
  EXPECT_EQ(share(0.1), 0.0);
  found_.push_back(path(0, 1e6F));
  EXPECT_NEAR(share(0.1), of_cell, 1e-9);
  EXPECT_NEAR(share(100.0), of_cell, 1e-9);
  found_.back().whole = true;
  EXPECT_EQ(share(0.1), 0.0) << "chains cannot make it";
}

TEST_F(RegionChoiceTest, NoSingleSampleTurnsTheDecision) {
  constexpr double kBad = 300.0;
  const RegionChoice before = choose(kBad);
  ASSERT_TRUE(before.fireflies_only);
  for (PilotPath& light : found_) {
    const PilotPath usual = light;
    light = path(light.sample, 1e6F);
    const RegionChoice after = choose(kBad);
    EXPECT_NEAR(after.regions.front().threshold, before.regions.front().threshold, 1e-3)
        << "sample " << light.sample;
    light = usual;
    if (light.sample > 40) break;
  }
}

TEST_F(RegionChoiceTest, ChainsAreHopelessWhereEvenFirefliesDoNotPay) {
  constexpr double kBad = 200.0;
  const RegionChoice even = choose(kBad);
  EXPECT_TRUE(even.is_hopeless());
  const RegionChoice without = without_chains(even, 3);
  ASSERT_EQ(without.regions.size(), 3U);
  EXPECT_EQ(without.regions.back().target_scale, 0.F);
  EXPECT_EQ(without.regions.back().deposit_scale, 0.F);
  found_.front() = path(0, 1e6F);
  EXPECT_TRUE(choose(kBad).has_hope()) << "a single sample may be luck, which is hoped for";
  found_.clear();
  EXPECT_FALSE(choose(kBad).is_hopeless()) << "nothing was found";
  EXPECT_FALSE(choose(kBad).has_hope());
}

/// A lucky sample of any strength.
TEST_F(RegionChoiceTest, ALittleGainIsNoHope) {
  int looked_at = 0;
  for (float strength = 10.F; strength < 1e6F; strength *= 1.1F) {
    found_.front() = path(0, strength);
    const RegionChoice choice = choose(300.0);
    if (!choice.hoped_error || *choice.hoped_error < 0.4 || *choice.hoped_error > 0.95) continue;
    ++looked_at;
    EXPECT_TRUE(choice.is_hopeless()) << *choice.hoped_error;
  }
  EXPECT_GT(looked_at, 0);
}

TEST_F(RegionChoiceTest, SeveralSamplesTurnTheDecision) {
  constexpr double kFair = 1.0;
  const double before = threshold(kFair);
  for (std::size_t i = 0; i < found_.size(); i += 49) found_[i] = path(i, 100.F);
  EXPECT_LT(threshold(kFair), 0.5 * before);
}

/// The halves of the replicates would do without chains and with them on either side of a step.
TEST_F(RegionChoiceTest, ThresholdsRiseByDegreesAsChainsPayLess) {
  for (std::size_t i = 0; i < found_.size(); i += 19) found_[i] = path(i, 30.F);
  constexpr double kStep = 1.01;
  constexpr double kFirst = 0.01;
  double last = threshold(kFirst);
  const double first = last;
  double steepest = 1.0;
  for (double correlation = kFirst; correlation < 1000.0; correlation *= kStep) {
    const double now = threshold(correlation);
    steepest = std::max(steepest, now / last);
    last = now;
  }
  EXPECT_GT(last, 90.0) << "they stand by";
  EXPECT_LT(first, 5.0);
  EXPECT_LT(steepest, 4.0) << "as far as one candidate is from the next";
}

/// A little less predicted error is no reason: on some scenes it is the pilot's noise.
TEST_F(RegionChoiceTest, ChainsStandByUnlessTheyClearlyPay) {
  constexpr double kClear = SelectiveHeuristics::kClearGain;
  for (std::size_t i = 0; i < found_.size(); i += 19) found_[i] = path(i, 30.F);
  int cases_that_hardly_pay = 0;
  int cases_that_clearly_pay = 0;
  for (double correlation = 0.1; correlation < 10.0; correlation *= 1.1) {
    const RegionChoice choice = choose(correlation);
    const float threshold = choice.regions.front().threshold;
    if (choice.expected_error >= kClear) {
      cases_that_hardly_pay += choice.expected_error < 1.0 ? 1 : 0;
      EXPECT_GT(threshold, 90.F) << choice.expected_error;
    } else if (choice.expected_error < 0.5 * kClear) {
      // At most the geometric mean of 100 and what pays most.
      ++cases_that_clearly_pay;
      EXPECT_LT(threshold, 20.F) << choice.expected_error;
    }
  }
  EXPECT_GE(cases_that_hardly_pay, 3);
  EXPECT_GE(cases_that_clearly_pay, 3);
}

}  // namespace
}  // namespace ajar
