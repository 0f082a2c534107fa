#include "integrator/montecarlo/ray_price.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/archive.h"

namespace ajar {
namespace {

const Vec2 kPlace(3.5F, 2.5F);
const ImportanceMap kEven;

TEST(RayPrice, IsTheRootOfVariancePerRay) {
  RayPrice price(kEven, 0.5, 2.0);
  EXPECT_FLOAT_EQ(price.rays_per_unit_light(kPlace), 2.F);
  EXPECT_EQ(price.rest(), 2.0);
  price.adjust(std::vector<double>(10, 36.0), 4.0);
  EXPECT_FLOAT_EQ(price.rays_per_unit_light(kPlace), 1.F / 3.F);
}

TEST(RayPrice, IsLowerWhereLightIsImportant) {
  const Box2i crop(Vec2i(3, 2), Vec2i(4, 2));
  const ImportanceMap importance(crop, {1.F, 3.F});  // scaled to a mean of 1
  const RayPrice price(importance, 0.5, 1.0);
  EXPECT_FLOAT_EQ(price.rays_per_unit_light(kPlace), 1.F);
  EXPECT_FLOAT_EQ(price.rays_per_unit_light(kPlace + Vec2(1.F, 0.F)), 3.F);
}

TEST(RayPrice, IsRobustToFireflies) {
  RayPrice price(kEven, 1.0, 1.0);
  std::vector<double> variance(1000, 1.0);
  variance.front() = 1e6;
  price.adjust(variance, 1.0);
  EXPECT_GT(price.rays_per_unit_light(kPlace), 0.8F) << "by squares, it would be 0.03";
}

TEST(RayPrice, StaysWhereThereIsNoNoise) {
  RayPrice price(kEven, 0.5, 1.0);
  price.adjust(std::vector<double>(10, 0.0), 4.0);
  EXPECT_FLOAT_EQ(price.rays_per_unit_light(kPlace), 2.F);
  price.adjust(std::vector<double>(10, 1.0), 0.0);  // nor any rays
  EXPECT_FLOAT_EQ(price.rays_per_unit_light(kPlace), 2.F);
  price.adjust({}, 1.0);
  EXPECT_FLOAT_EQ(price.rays_per_unit_light(kPlace), 2.F);
}

TEST(RayPrice, SurvivesAnArchive) {
  RayPrice price(kEven, 0.5, 1.0);
  price.adjust(std::vector<double>(10, 36.0), 4.0);
  const std::string bytes = archived([&](OutputArchive& out) { price.save_state(out); });
  RayPrice again(kEven, 0.5, 1.0);
  InputArchive archive(bytes);
  again.load_state(archive);
  EXPECT_EQ(again.rays_per_unit_light(kPlace), price.rays_per_unit_light(kPlace));
}

TEST(RayPrice, RefusesInvalidStates) {
  for (const double wrong : {0.0, -1.0, 1e-300, 1e300, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    const std::string bytes = archived([&](OutputArchive& out) { out(wrong); });
    RayPrice price(kEven, 0.5, 1.0);
    InputArchive archive(bytes);
    EXPECT_THROW(price.load_state(archive), std::exception) << wrong;
  }
}

}  // namespace
}  // namespace ajar
