#include "import/mesh/smooth_normals.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

TEST(SmoothNormals, AreMeansWeightedByTheAnglesAtTheVertex) {
  // A corner of a cube: two triangles of the face z = 0 share its diagonal, one is in y = 0.
  desc::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}};
  mesh.indices = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}};
  make_smooth_normals(mesh);
  ASSERT_EQ(mesh.normals.size(), 6U);
  // At the origin the two faces have the same angle, although one has two triangles.
  const float half = std::sqrt(0.5F);
  EXPECT_NEAR(length(mesh.normals[0] - Vec3(0.F, half, half)), 0.F, 1e-6F);
  EXPECT_NEAR(length(mesh.normals[2] - Vec3(0.F, 0.F, 1.F)), 0.F, 1e-6F);
  EXPECT_NEAR(length(mesh.normals[4] - Vec3(0.F, 1.F, 0.F)), 0.F, 1e-6F);
  EXPECT_EQ(mesh.normals[5], Vec3(0.F, 0.F, 1.F));
}

}  // namespace
}  // namespace ajar
