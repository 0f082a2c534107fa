#include "integrator/regions/surface_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace ajar {
namespace {

std::vector<PixelIdentity> objects(const std::vector<std::uint32_t>& numbers) {
  std::vector<PixelIdentity> identities;
  identities.reserve(numbers.size());
  for (const std::uint32_t number : numbers) identities.push_back({number, number});
  return identities;
}
using Values = std::vector<float>;

TEST(SurfaceEdges, AreBetweenDifferentThings) {
  const auto identities = objects({1, 1, 1, 1,  //
                                   1, 1, 2, 1,  //
                                   1, 1, 1, 1});
  const Plane edges = surface_edges({.size = Vec2i(4, 3), .identities = identities});
  EXPECT_EQ(edges.values, (Values{0, 0, 1, 0,  //
                                  0, 1, 1, 1,  //
                                  0, 0, 1, 0}));
}

TEST(SurfaceEdges, AreBetweenMaterialsAndTowardsNothing) {
  const std::vector<PixelIdentity> identities = {{1, 1}, {1, 1}, {1, 2}, {1, 2}, {0, 0}, {0, 0}};
  EXPECT_EQ(surface_edges({.size = Vec2i(6, 1), .identities = identities}).values,
            (Values{0, 1, 1, 1, 1, 0}));
  EXPECT_EQ(surface_edges({.size = Vec2i(1, 6), .identities = identities}).values,
            (Values{0, 1, 1, 1, 1, 0}));
}

TEST(SurfaceEdges, DoNotGoAroundTheBorder) {
  const auto identities = objects({1, 1, 2, 2,  //
                                   1, 1, 2, 2});
  EXPECT_EQ(surface_edges({.size = Vec2i(4, 2), .identities = identities}).values,
            (Values{0, 1, 1, 0, 0, 1, 1, 0}));
}

TEST(SurfaceEdges, GrowWithTheRelativeStepOfDepth) {
  const auto identities = objects({1, 1, 1, 1});
  for (const float unit : {0.01F, 1.F, 1000.F}) {
    const Values depths = {4.F * unit, 4.F * unit, 4.1F * unit, 5.F * unit};
    const Plane edges =
        surface_edges({.size = Vec2i(4, 1), .identities = identities, .depths = depths});
    EXPECT_EQ(edges.values[0], 0.F);
    EXPECT_NEAR(edges.values[1], 0.5F, 1e-4F);
    EXPECT_EQ(edges.values[2], 1.F);
    EXPECT_EQ(edges.values[3], 1.F);
  }
}

TEST(SurfaceEdges, GrowWithTheAngleBetweenNormals) {
  const auto identities = objects({1, 1, 1, 1});
  const float angle = 0.175F;
  // Normals of different lengths, as means of several samples are.
  const Values normals = {0, 0,  1, 0, 0, 0.5F, 0.7F * std::sin(angle), 0, 0.7F * std::cos(angle),
                          0, -1, 0};
  const Plane edges =
      surface_edges({.size = Vec2i(4, 1), .identities = identities, .normals = normals});
  EXPECT_EQ(edges.values[0], 0.F);
  EXPECT_NEAR(edges.values[1], 0.5F, 1e-5F);
  EXPECT_EQ(edges.values[2], 1.F);
}

TEST(SurfaceEdges, TakeNothingFromWhatIsUnknown) {
  const float infinity = std::numeric_limits<float>::infinity();
  const auto identities = objects({1, 1, 1, 1});
  const Values depths = {1.F, std::nanf(""), infinity, 0.F};
  const Values normals = {0, 0, 1, 0, 0, 0, std::nanf(""), 0, 1, infinity, 0, 0};
  const Plane edges = surface_edges(
      {.size = Vec2i(4, 1), .identities = identities, .depths = depths, .normals = normals});
  EXPECT_EQ(edges.values, Values(4, 0.F));
  // Where nothing is there, there is no depth either.
  const auto nothing = objects({0, 0});
  const Values steps = {1.F, 9.F};
  EXPECT_EQ(surface_edges({.size = Vec2i(2, 1), .identities = nothing, .depths = steps}).values,
            Values(2, 0.F));
}

TEST(SurfaceEdges, RefuseLayersThatDoNotFit) {
  const auto identities = objects({1, 1});
  const Values three(3);
  const Vec2i size(2, 1);
  EXPECT_THROW(surface_edges({.size = Vec2i(3, 1), .identities = identities}),
               std::invalid_argument);
  EXPECT_THROW(surface_edges({.size = size, .identities = identities, .depths = three}),
               std::invalid_argument);
  EXPECT_THROW(surface_edges({.size = size, .identities = identities, .normals = three}),
               std::invalid_argument);
  EXPECT_THROW(surface_edges({.size = size, .identities = identities}, {.depth_step = 0.F}),
               std::invalid_argument);
}

TEST(EdgesOfMap, AreWhereTheMapTakesAStep) {
  Plane edges(Vec2i(5, 1));
  edges.values = {1.F, 1.F, 0.5F, 1.F, 1.F};
  Plane map(Vec2i(5, 1));
  map.values = {0.1F, 0.1F, 1.F, 1.F, 1.F};
  EXPECT_EQ(edges_of_map(edges, map).values, (Values{0.F, 1.F, 0.5F, 0.F, 0.F}));
  EXPECT_THROW(edges_of_map(edges, Plane(Vec2i(1, 5))), std::invalid_argument);
}

}  // namespace
}  // namespace ajar
