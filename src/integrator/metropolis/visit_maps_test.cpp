#include "integrator/metropolis/visit_maps.h"

#include <gtest/gtest.h>

#include "mcmc/primary/gaussian_mutation.h"

namespace ajar {
namespace {

const GaussianMutation kMutation;

PlaneRule neighbours(bool published) {
  PlaneRule rule;
  rule.neighbours = true;
  rule.published = published;
  rule.neighbour_visits = 10.0;
  return rule;
}

/// 4 × 4 pixels, seen half a pixel beyond each border.
ChainView view() {
  ChainView view;
  view.low = {-0.5F, -0.5F};
  view.size = {5.F, 5.F};
  return view;
}

/// Primary numbers of a raster position.
Vec2 primary(float x, float y) { return {(x + 0.5F) / 5.F, (y + 0.5F) / 5.F}; }

TEST(VisitMaps, ExactMapsComeFromTheOtherReplicatesOnce) {
  VisitMaps maps(neighbours(false), view(), 3, 1.0, kMutation);
  maps.add(0, {1.5F, 1.5F}, 8.0, 1.0);
  maps.add(1, {2.5F, 3.5F}, 7.0, 1.0);
  maps.add(2, {4.4F, 0.5F}, 6.0, 1.0);  // beyond the border
  maps.end_epoch(8);
  EXPECT_TRUE(maps.gathers());
  EXPECT_EQ(maps.moves(0), nullptr) << "too few mutations";
  maps.end_epoch(16);
  ASSERT_NE(maps.moves(0), nullptr);
  EXPECT_FALSE(maps.moves(0)->dense(primary(1.5F, 1.5F))) << "its own visits";
  // Scaled by 3/2: 12, 10.5 and 9 visits.
  EXPECT_TRUE(maps.moves(1)->dense(primary(1.5F, 1.5F)));
  EXPECT_TRUE(maps.moves(2)->dense(primary(1.5F, 1.5F)));
  EXPECT_TRUE(maps.moves(0)->dense(primary(2.5F, 3.5F)));
  EXPECT_FALSE(maps.moves(1)->dense(primary(2.5F, 3.5F)));
  EXPECT_FALSE(maps.moves(0)->dense(primary(4.4F, 0.5F)));
  EXPECT_FALSE(maps.moves(0)->published());

  EXPECT_FALSE(maps.gathers());
  const PlaneMoves* before = maps.moves(0);
  maps.add(1, {0.5F, 0.5F}, 1000.0, 1.0);
  maps.end_epoch(32);
  EXPECT_EQ(maps.moves(0), before);
}

TEST(VisitMaps, ASingleReplicateNeverAdaptsExactly) {
  VisitMaps maps(neighbours(false), view(), 1, 1.0, kMutation);
  maps.add(0, {1.5F, 1.5F}, 1000.0, 1.0);
  maps.end_epoch(1024);
  EXPECT_EQ(maps.moves(0), nullptr);
}

TEST(VisitMaps, PublishedMapsAreSharedAndGrow) {
  VisitMaps maps(neighbours(true), view(), 2, 1.0, kMutation);
  maps.add(0, {1.5F, 1.5F}, 6.0, 1.0);
  maps.add(1, {1.5F, 1.5F}, 6.0, 1.0);
  maps.add(1, {2.5F, 2.5F}, 6.0, 1.0);
  maps.end_epoch(16);
  EXPECT_EQ(maps.moves(0), maps.moves(1));
  EXPECT_TRUE(maps.moves(0)->dense(primary(1.5F, 1.5F)));
  EXPECT_FALSE(maps.moves(0)->dense(primary(2.5F, 2.5F)));
  EXPECT_TRUE(maps.gathers());
  maps.add(0, {2.5F, 2.5F}, 6.0, 1.0);
  maps.end_epoch(32);
  EXPECT_TRUE(maps.moves(0)->dense(primary(2.5F, 2.5F)));
}

}  // namespace
}  // namespace ajar
