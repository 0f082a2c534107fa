#include "import/mesh/creased_normals.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ajar {
namespace {

/// Two triangles that share an edge along y and turn by an angle there, of which the second has
/// vertices of its own.
desc::Mesh folded(float degrees) {
  const float angle = degrees * kPi / 180.F;
  const Vec3 fold(std::cos(angle), 0.F, std::sin(angle));
  desc::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, fold};
  mesh.uvs = {{0, 0}, {0, 1}, {-1, 0}, {0, 0}, {0, 1}, {1, 0}};
  mesh.indices = {{0, 1, 2}, {3, 5, 4}};
  return mesh;
}

const float kLimit = std::cos(27.F * kPi / 180.F);

TEST(CreasedNormals, AreTheMeanAtAnEdgeThatIsNotSharp) {
  const desc::Mesh mesh = with_creased_normals(folded(20.F), kLimit);
  ASSERT_EQ(mesh.indices.size(), 2U);
  const Vec3 first = mesh.normals[mesh.indices[0].x];
  const Vec3 same_place = mesh.normals[mesh.indices[1].x];
  EXPECT_LT(length(first - same_place), 1e-6F);
  const float half = 10.F * kPi / 180.F;
  EXPECT_LT(length(first - Vec3(-std::sin(half), 0.F, std::cos(half))), 1e-6F);
  // The corner that only one triangle has keeps its normal.
  EXPECT_LT(length(mesh.normals[mesh.indices[0].z] - Vec3(0.F, 0.F, 1.F)), 1e-6F);
  EXPECT_EQ(mesh.uvs[mesh.indices[1].y], Vec2(1.F, 0.F));
}

TEST(CreasedNormals, AreThoseOfTheTrianglesAtASharpEdge) {
  const desc::Mesh mesh = with_creased_normals(folded(40.F), kLimit);
  EXPECT_LT(length(mesh.normals[mesh.indices[0].x] - Vec3(0.F, 0.F, 1.F)), 1e-6F);
}

}  // namespace
}  // namespace ajar
