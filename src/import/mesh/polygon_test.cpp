#include "import/mesh/polygon.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ajar {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles cut(const std::vector<Vec3>& corners) {
  Triangles triangles;
  triangulate(corners, triangles);
  return triangles;
}

Vec3d area_of(const std::vector<Vec3>& corners, const std::array<std::uint32_t, 3>& t) {
  const Vec3d a(corners[t[0]]);
  return (Vec3d(corners[t[1]]) - a).cross(Vec3d(corners[t[2]]) - a) * 0.5;
}

/// The triangles face `normal`, and cover exactly `area`: none of them lies on another.
void expect_covered(const std::vector<Vec3>& corners, const Vec3d& normal, double area) {
  double sum = 0.0;
  for (const auto& t : cut(corners)) {
    const double part = area_of(corners, t).dot(normal);
    EXPECT_GE(part, 0.0);
    sum += part;
  }
  EXPECT_NEAR(sum, area, 1e-6 * area);
}

TEST(Polygon, ConvexOnesAreFanned) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}), (Triangles{{0, 1, 2}}));
  EXPECT_TRUE(cut({{0, 0, 0}, {1, 0, 0}}).empty());
}

TEST(Polygon, QuadsWithADentAreCutAtIt) {
  // A fan from the first corner would cover area outside.
  EXPECT_EQ(cut({{0, 2, 0}, {-1, 0, 0}, {0, 1, 0}, {1, 0, 0}}).size(), 2U);
  for (std::size_t first = 0; first < 4; ++first) {
    std::vector<Vec3> dart = {{0, 2, 0}, {-1, 0, 0}, {0, 1, 0}, {1, 0, 0}};
    std::rotate(dart.begin(), dart.begin() + static_cast<std::ptrdiff_t>(first), dart.end());
    expect_covered(dart, {0, 0, 1}, 1.0);
    std::reverse(dart.begin(), dart.end());
    expect_covered(dart, {0, 0, -1}, 1.0);
  }
}

TEST(Polygon, StarsAndCombsAreCovered) {
  std::vector<Vec3> star;
  for (int i = 0; i < 20; ++i) {
    const double angle = 2.0 * M_PI * i / 20.0;
    const double radius = i % 2 == 0 ? 2.0 : 0.7;
    star.emplace_back(Vec3d(5.0, radius * std::cos(angle), radius * std::sin(angle)));
  }
  expect_covered(star, {1, 0, 0}, 20 * 0.5 * 2.0 * 0.7 * std::sin(2.0 * M_PI / 20.0));
  // Ten teeth of the area 1 on a back of 19 × 1.
  std::vector<Vec3> comb = {{0, -1, 0}, {19, -1, 0}};
  for (int i = 9; i >= 0; --i) {
    const auto x = static_cast<float>(2 * i);
    for (const Vec3& corner :
         {Vec3(x + 1, 0, 0), Vec3(x + 1, 1, 0), Vec3(x, 1, 0), Vec3(x, 0, 0)}) {
      comb.push_back(corner);
    }
  }
  expect_covered(comb, {0, 0, 1}, 29.0);
}

TEST(Polygon, HolesMayBeReachedByACut) {
  // A wall of 4 × 4 with a window of 2 × 2, as drawing programs write it.
  const std::vector<Vec3> wall = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                  {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  expect_covered(wall, {0, 0, 1}, 12.0);
}

TEST(Polygon, DegenerateOnesAreFanned) {
  const float nan = std::nanf("");
  EXPECT_EQ(cut({{0, 0, 0}, {1, nan, 0}, {1, 1, 0}, {0, 1, 0}}).size(), 2U);
  EXPECT_EQ(cut(std::vector<Vec3>(5, Vec3(1.F))).size(), 3U);
  EXPECT_LE(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2U) << "it crosses itself";
  std::vector<Vec3> large(1000, Vec3(0.F));
  EXPECT_EQ(cut(large).size(), 998U);
}

}  // namespace
}  // namespace ajar
