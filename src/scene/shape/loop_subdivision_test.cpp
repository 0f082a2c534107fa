#include "scene/shape/loop_subdivision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace ajar {
namespace {

desc::Mesh octahedron() {
  desc::Mesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.indices = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

desc::Mesh square() {
  desc::Mesh mesh;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) mesh.positions.emplace_back(i, j, 0);
  }
  for (unsigned j = 0; j < 2; ++j) {
    for (unsigned i = 0; i < 2; ++i) {
      const unsigned a = 3 * j + i;
      mesh.indices.emplace_back(a, a + 1, a + 4);
      mesh.indices.emplace_back(a, a + 4, a + 3);
    }
  }
  return mesh;
}

Vec3 face_normal(const desc::Mesh& mesh, std::size_t i) {
  const auto& t = mesh.indices[i];
  return cross(mesh.positions[t.y] - mesh.positions[t.x],
               mesh.positions[t.z] - mesh.positions[t.x]);
}

TEST(LoopSubdivision, KeepsTheEulerCharacteristic) {
  Warnings warnings;
  for (int levels = 0; levels <= 4; ++levels) {
    const auto mesh = subdivide(octahedron(), levels, {}, warnings);
    std::set<std::pair<unsigned, unsigned>> edges;
    for (const auto& t : mesh->indices) {
      for (int k = 0; k < 3; ++k) edges.insert(std::minmax({t[k], t[(k + 1) % 3]}));
    }
    const auto v = static_cast<long>(mesh->positions.size());
    const auto f = static_cast<long>(mesh->indices.size());
    EXPECT_EQ(v - static_cast<long>(edges.size()) + f, 2);
    EXPECT_EQ(f, 8L << (2 * levels));
  }
  EXPECT_EQ(warnings.count(), 0U);
}

TEST(LoopSubdivision, OctahedronBecomesSmooth) {
  Warnings warnings;
  double previous = 10.0;
  for (int levels = 2; levels <= 5; ++levels) {
    const auto mesh = subdivide(octahedron(), levels, {}, warnings);
    double worst = 0.0;
    for (std::size_t i = 0; i < mesh->indices.size(); ++i) {
      const Vec3 n = normalize(face_normal(*mesh, i));
      for (int k = 0; k < 3; ++k) {
        // Normals point against the winding, as pbrt's do.
        const float cosine = -dot(n, mesh->normals[mesh->indices[i][k]]);
        worst = std::max(worst, std::acos(std::min(1.0, double{cosine})));
      }
    }
    // The ratio of the two largest eigenvalues below one at vertices of valence 4 is 2/3.
    EXPECT_LT(worst, 0.72 * previous) << levels;
    previous = worst;
  }
  EXPECT_LT(previous, 0.2);
}

TEST(LoopSubdivision, LimitPositionsDoNotDependOnLevels) {
  Warnings warnings;
  const auto coarse = subdivide(octahedron(), 1, {}, warnings);
  const auto fine = subdivide(octahedron(), 4, {}, warnings);
  // Even vertices keep their index, and the limit of a point is the same from every level.
  for (std::size_t i = 0; i < coarse->positions.size(); ++i) {
    EXPECT_LT(length(coarse->positions[i] - fine->positions[i]), 1e-6F) << i;
    EXPECT_GT(dot(coarse->normals[i], fine->normals[i]), 0.9999F) << i;
  }
}

TEST(LoopSubdivision, BoundaryOfAFlatSquareStaysFlatAndSymmetric) {
  Warnings warnings;
  const auto mesh = subdivide(square(), 3, {}, warnings);
  float low = 1.F;
  float high = 0.F;
  for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
    EXPECT_EQ(mesh->positions[i].z, 0.F);
    EXPECT_NEAR(mesh->normals[i].z, -1.F, 1e-5F);
    low = std::min(low, mesh->positions[i].x);
    high = std::max(high, mesh->positions[i].x);
  }
  // The middle of a straight edge between equal neighbours stays on it.
  EXPECT_NEAR(low, 0.F, 1e-6F);
  EXPECT_NEAR(high, 2.F, 1e-6F);
}

TEST(LoopSubdivision, NonManifoldMeshIsKeptWithAWarning) {
  Warnings warnings;
  desc::Mesh control = octahedron();
  control.indices.push_back(control.indices.front());
  const auto mesh = subdivide(control, 2, {}, warnings);
  EXPECT_EQ(mesh->indices.size(), 9U);
  EXPECT_EQ(warnings.count(), 1U);
}

TEST(LoopSubdivision, IndexOutOfRangeIsAnError) {
  Warnings warnings;
  desc::Mesh control = octahedron();
  control.indices[3].y = 6;
  EXPECT_THROW(subdivide(control, 1, {}, warnings), SceneError);
}

}  // namespace
}  // namespace ajar
