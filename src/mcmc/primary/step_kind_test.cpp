#include "mcmc/primary/step_kind.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>

namespace ajar {
namespace {

TEST(StepKind, IsChosenWithItsProbability) {
  const StepProbabilities probabilities{0.3, 0.5, 0.25, 0.0, 0.6};
  constexpr int kSamples = 100000;
  std::vector<int> counts(primary_moves().size());
  for (int i = 0; i < kSamples; ++i) {
    ++counts[static_cast<std::size_t>(probabilities.choose((i + 0.5) / kSamples))];
  }
  // Evenly spaced u: exact up to the cells at the borders.
  EXPECT_NEAR(counts[0], 0.3 * kSamples, 2);
  EXPECT_NEAR(counts[1], 0.7 * 0.4 * 0.25 * kSamples, 2);
  EXPECT_NEAR(counts[2], 0.7 * 0.4 * 0.5 * kSamples, 2);
  EXPECT_NEAR(counts[3], 0.7 * 0.4 * 0.25 * kSamples, 2);
  EXPECT_NEAR(counts[4], 0.7 * 0.6 * kSamples, 2);
}

TEST(StepKind, LengthsAreChosenWithTheirProbability) {
  const StepProbabilities probabilities{.fine = 0.3};
  constexpr int kSamples = 100000;
  std::map<std::uint64_t, int> counts;
  for (int i = 0; i < kSamples; ++i) ++counts[probabilities.choose_length((i + 0.5) / kSamples)];
  ASSERT_EQ(counts.size(), 3U);
  EXPECT_NEAR(counts[kStepUnits], 0.7 * kSamples, 2);
  EXPECT_NEAR(counts[kStepUnits / 64], 0.15 * kSamples, 2);
  EXPECT_NEAR(counts[kStepUnits / 4096], 0.15 * kSamples, 2);
  EXPECT_EQ(StepProbabilities{}.choose_length(0.0), kStepUnits);
}

TEST(StepKind, CanBeAllOfOneKind) {
  const double nearly_one = std::nextafter(1.0, 0.0);
  for (const double u : {0.0, 0.5, nearly_one}) {
    EXPECT_EQ((StepProbabilities{1.0, 0.0, 0.0}.choose(u)), StepKind::Large);
    EXPECT_EQ((StepProbabilities{0.0, 0.0, 0.0}.choose(u)), StepKind::SmallBoth);
    EXPECT_EQ((StepProbabilities{0.0, 1.0, 0.0}.choose(u)), StepKind::SmallCamera);
    EXPECT_EQ((StepProbabilities{0.0, 0.0, 1.0}.choose(u)), StepKind::SmallLight);
    EXPECT_EQ((StepProbabilities{0.0, 0.5, 0.5, 0.0, 1.0}.choose(u)), StepKind::SmallRaster);
  }
}

TEST(StepKind, RefusesInvalidProbabilities) {
  EXPECT_THROW((StepProbabilities{1.1, 0.0, 0.0}.check()), std::invalid_argument);
  EXPECT_THROW((StepProbabilities{0.3, 0.6, 0.6}.check()), std::invalid_argument);
  EXPECT_THROW((StepProbabilities{0.3, -0.1, 0.0}.check()), std::invalid_argument);
  EXPECT_THROW((StepProbabilities{std::nan(""), 0.0, 0.0}.check()), std::invalid_argument);
  EXPECT_THROW((StepProbabilities{.fine = 1.1}.check()), std::invalid_argument);
  EXPECT_THROW((StepProbabilities{.raster = -0.1}.check()), std::invalid_argument);
  EXPECT_NO_THROW((StepProbabilities{0.3, 0.5, 0.5}.check()));
}

TEST(StepKind, ConnectionMovesWithTheSelectedHalves) {
  EXPECT_TRUE(change_of(StepKind::SmallCamera, {}, true).connection);
  EXPECT_FALSE(change_of(StepKind::SmallLight, {}, true).connection);
  EXPECT_FALSE(change_of(StepKind::SmallCamera, {false, true}, true).connection);
  EXPECT_TRUE(change_of(StepKind::SmallLight, {false, true}, true).connection);
  EXPECT_TRUE(change_of(StepKind::SmallBoth, {false, false}, true).connection);
  EXPECT_FALSE(change_of(StepKind::SmallCamera, {}, true).light);
  EXPECT_FALSE(change_of(StepKind::SmallLight, {}, true).camera);
}

TEST(StepKind, StepsOfTheRasterNumbersNeverDecideWhetherAStateUsesThem) {
  for (const ConnectionMoves moves : {ConnectionMoves{}, ConnectionMoves{true, true}}) {
    const Change placed = change_of(StepKind::SmallRaster, moves, true);
    EXPECT_TRUE(placed.raster && placed.moves_camera_half());
    EXPECT_FALSE(placed.camera || placed.light || placed.connection);
    const Change other = change_of(StepKind::SmallRaster, moves, false);
    EXPECT_TRUE(other.light);
    EXPECT_FALSE(other.raster || other.moves_camera_half() || other.connection);
  }
  EXPECT_FALSE(change_of(StepKind::SmallLight, {}, true).moves_camera_half());
  EXPECT_TRUE(change_of(StepKind::SmallCamera, {}, true).moves_camera_half());
}

}  // namespace
}  // namespace ajar
