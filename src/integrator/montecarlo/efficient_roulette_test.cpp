#include "integrator/montecarlo/efficient_roulette.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/archive.h"

namespace ajar {
namespace {

const Box3 kScene(Vec3(-1.F, -1.F, -1.F), Vec3(1.F, 1.F, 1.F));
const Box2i kCrop(Vec2i(3, 2), Vec2i(4, 2));
const Vec2 kFirst(3.5F, 2.5F);
const Vec2 kSecond(4.5F, 2.5F);
const ImportanceMap kEven;

EfficientRoulette roulette_for(const Box2i& crop) { return {kScene, crop, 1.0}; }

TEST(EfficientRoulette, KnowsThePriceOfARay) {
  EfficientRoulette roulette = roulette_for(kCrop);
  EXPECT_FALSE(roulette.is_known());
  roulette.count(40, 10);
  roulette.end_round(kEven, std::vector<double>(2, 36.0));
  EXPECT_TRUE(roulette.is_known());
  EXPECT_NEAR(roulette.price(), 3.0, 1e-9) << "the root of variance per ray";
  EXPECT_FLOAT_EQ(roulette.rays_per_unit_light(kFirst), 1.F / 3.F);
}

TEST(EfficientRoulette, HasLowerPricesWhereLightIsImportant) {
  const ImportanceMap importance(kCrop, {1.F, 3.F});  // scaled to a mean of 1
  EfficientRoulette roulette = roulette_for(kCrop);
  roulette.count(1, 1);
  roulette.end_round(importance, std::vector<double>(2, 0.25));
  EXPECT_FLOAT_EQ(roulette.rays_per_unit_light(kFirst), 1.F);
  EXPECT_FLOAT_EQ(roulette.rays_per_unit_light(kSecond), 3.F);
}

TEST(EfficientRoulette, IsRobustToFireflies) {
  const Box2i crop(Vec2i(0, 0), Vec2i(999, 0));
  EfficientRoulette roulette = roulette_for(crop);
  std::vector<double> variance(1000, 1.0);
  variance.front() = 1e6;
  roulette.count(1, 1);
  roulette.end_round(kEven, variance);
  EXPECT_GT(roulette.rays_per_unit_light(kFirst), 0.8F) << "by squares, it would be 0.03";
}

TEST(EfficientRoulette, StaysWhereThereIsNoNoise) {
  EfficientRoulette roulette = roulette_for(kCrop);
  roulette.end_round(kEven, std::vector<double>(2, 1.0));
  EXPECT_FALSE(roulette.is_known()) << "there were no rays";
  roulette.count(4, 1);
  roulette.end_round(kEven, std::vector<double>(2, 0.0));
  EXPECT_FALSE(roulette.is_known());
  roulette.end_round(kEven, std::vector<double>(2, 1.0));
  EXPECT_FLOAT_EQ(roulette.rays_per_unit_light(kFirst), 2.F);
  roulette.end_round(kEven, std::vector<double>(2, 0.0));
  EXPECT_FLOAT_EQ(roulette.rays_per_unit_light(kFirst), 2.F);
}

TEST(EfficientRoulette, GoesOnFromACheckpoint) {
  EfficientRoulette roulette = roulette_for(kCrop);
  roulette.count(4, 1);
  roulette.end_round(kEven, std::vector<double>(2, 36.0));
  const std::string bytes = archived([&](OutputArchive& out) { roulette.save_state(out); });
  EfficientRoulette again = roulette_for(kCrop);
  InputArchive archive(bytes);
  again.load_state(archive);
  EXPECT_EQ(again.rays_per_unit_light(kFirst), roulette.rays_per_unit_light(kFirst));
  for (EfficientRoulette* each : {&roulette, &again}) {
    each->count(12, 1);
    each->end_round(kEven, std::vector<double>(2, 36.0));
  }
  EXPECT_EQ(again.price(), roulette.price());
}

TEST(EfficientRoulette, RefusesPricesThatCannotBe) {
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    const std::string bytes = archived([&](OutputArchive& out) {
      out(wrong, std::vector<float>{1.F, 1.F}, std::uint64_t{4}, std::uint64_t{1});
      EfficiencyCells(kScene, 1.0).save_state(out);
    });
    EfficientRoulette roulette = roulette_for(kCrop);
    InputArchive archive(bytes);
    EXPECT_THROW(roulette.load_state(archive), std::exception) << wrong;
  }
}

}  // namespace
}  // namespace ajar
