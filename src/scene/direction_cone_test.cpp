#include "scene/direction_cone.h"

#include <gtest/gtest.h>

#include "core/warp.h"
#include "scene/testing/endpoint_checks.h"

namespace ajar {
namespace {

TEST(DirectionCone, UnionTouchesBothFarSides) {
  Rng rng(1);
  for (int i = 0; i < 1000; ++i) {
    const DirectionCone a{warp::uniform_sphere(testing::next_pair(rng)), kPi * rng.next()};
    const DirectionCone b{warp::uniform_sphere(testing::next_pair(rng)), kPi * rng.next()};
    const DirectionCone both = unite(a, b);
    const float reach = std::max(angle_between(both.axis, a.axis) + a.angle,
                                 angle_between(both.axis, b.axis) + b.angle);
    // Contains both, and no smaller cone around this axis does.
    EXPECT_NEAR(both.angle, std::min(reach, kPi), 1e-3F);
  }
}

TEST(DirectionCone, EmptyAddsNothingAndOppositesAddUpToEverything) {
  const DirectionCone up{Vec3(0.F, 0.F, 1.F), 0.2F};
  EXPECT_EQ(unite(up, {}).angle, 0.2F);
  EXPECT_EQ(unite({}, up).axis, up.axis);
  EXPECT_TRUE(unite({}, {}).is_empty());
  EXPECT_NEAR(unite(up, {Vec3(0.F, 0.F, -1.F), 0.2F}).angle, 0.5F * kPi + 0.2F, 1e-5F);
  EXPECT_TRUE(unite(up, {Vec3(0.F, 0.F, -1.F), 3.F}).is_whole_sphere());
}

}  // namespace
}  // namespace ajar
