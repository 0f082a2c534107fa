#include "scene/shape/triangle_mesh.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace ajar {
namespace {

// From plain numbers: GCC 12 warns without reason about initialiser lists of Imath's vectors.
std::vector<Vec3> points(std::initializer_list<float> numbers) {
  std::vector<Vec3> result;
  for (const float* n = numbers.begin(); n != numbers.end(); n += 3)
    result.emplace_back(n[0], n[1], n[2]);
  return result;
}
std::vector<Vec2> coordinates(std::initializer_list<float> numbers) {
  std::vector<Vec2> result;
  for (const float* n = numbers.begin(); n != numbers.end(); n += 2)
    result.emplace_back(n[0], n[1]);
  return result;
}

std::shared_ptr<desc::Mesh> triangle() {
  auto mesh = std::make_shared<desc::Mesh>();
  mesh->positions = points({0, 0, 0, 2, 0, 0, 0, 1, 0.5F});
  mesh->indices.emplace_back(0, 1, 2);
  return mesh;
}

class TriangleMeshTest : public ::testing::Test {
 protected:
  TriangleMesh make(std::shared_ptr<const desc::Mesh> mesh, const Mat4& m = Mat4(),
                    bool reversed = false) {
    return TriangleMesh(std::move(mesh), *Placement::make(m), reversed, where_, warnings_);
  }
  static SurfacePoint at(const TriangleMesh& mesh, float b1, float b2) {
    SurfacePoint point;
    mesh.surface_point(0, b1, b2, point);
    return point;
  }
  std::string error_of(std::shared_ptr<const desc::Mesh> mesh) {
    try {
      make(std::move(mesh));
    } catch (const SceneError& error) {
      return error.what();
    }
    return {};
  }
  SourceLocation where_{std::make_shared<const std::string>("scene.pbrt"), 7, 1};
  Warnings warnings_;
};

TEST_F(TriangleMeshTest, DerivativesFollowTheTextureCoordinates) {
  auto mesh = triangle();
  mesh->uvs = coordinates({0.1F, 0.2F, 0.6F, 0.3F, 0.2F, 0.9F});
  const TriangleMesh made = make(mesh);
  const SurfacePoint p = at(made, 0.2F, 0.3F);
  const SurfacePoint q = at(made, 0.25F, 0.35F);
  const Vec3 predicted = p.p + p.dpdu * (q.uv.x - p.uv.x) + p.dpdv * (q.uv.y - p.uv.y);
  EXPECT_LT(length(predicted - q.p), 1e-6F);
  EXPECT_EQ(p.dndu, Vec3(0.F));
}

TEST_F(TriangleMeshTest, WithoutCoordinatesPbrtsAreUsed) {
  const SurfacePoint p = at(make(triangle()), 0.2F, 0.3F);
  EXPECT_NEAR(p.uv.x, 0.5F, 1e-6F);
  EXPECT_NEAR(p.uv.y, 0.3F, 1e-6F);
  EXPECT_LT(length(p.dpdu - Vec3(2, 0, 0)), 1e-6F);
}

TEST_F(TriangleMeshTest, DegenerateCoordinatesStillGiveTangents) {
  auto mesh = triangle();
  mesh->uvs = coordinates({0.5F, 0.5F, 0.5F, 0.5F, 0.5F, 0.5F});
  const SurfacePoint p = at(make(mesh), 0.2F, 0.3F);
  EXPECT_NEAR(length(p.dpdu), 1.F, 1e-5F);
  EXPECT_NEAR(dot(p.dpdu, p.ng), 0.F, 1e-5F);
}

TEST_F(TriangleMeshTest, WindingDecidesWithoutNormals) {
  Mat4 mirror;
  mirror[0][0] = -1.0;
  const Vec3 n = normalize(Vec3(0.F, -0.5F, 1.F));
  EXPECT_GT(dot(at(make(triangle()), 0.2F, 0.3F).ng, n), 0.999F);
  EXPECT_LT(dot(at(make(triangle(), Mat4(), true), 0.2F, 0.3F).ng, n), -0.999F);
  // A mirrored shape keeps its outside outside.
  EXPECT_GT(dot(at(make(triangle(), mirror), 0.2F, 0.3F).ng, n), 0.999F);
  EXPECT_LT(dot(at(make(triangle(), mirror, true), 0.2F, 0.3F).ng, n), -0.999F);
}

TEST_F(TriangleMeshTest, AuthoredNormalsDecideTheSide) {
  auto mesh = triangle();
  mesh->normals = points({0, 0, -1, 0.1F, 0, -1, 0, -0.1F, -1});
  const SurfacePoint p = at(make(mesh), 0.2F, 0.3F);
  EXPECT_LT(p.ns.z, -0.9F);
  EXPECT_LT(p.ng.z, -0.5F);
  EXPECT_GT(dot(p.ns, p.ng), 0.F);
  const SurfacePoint reversed = at(make(mesh, Mat4(), true), 0.2F, 0.3F);
  EXPECT_GT(reversed.ns.z, 0.9F);
  EXPECT_GT(reversed.ng.z, 0.5F);
}

TEST_F(TriangleMeshTest, NormalDerivativesMatchDifferences) {
  auto mesh = triangle();
  mesh->uvs = coordinates({0.1F, 0.2F, 0.6F, 0.3F, 0.2F, 0.9F});
  mesh->normals = points({0, 0, 1, 0.7F, 0, 0.7F, 0, -0.5F, 0.8F});
  Mat4 shear;
  shear[1][0] = 0.4;
  shear[2][2] = 3.0;
  const TriangleMesh made = make(mesh, shear);
  const SurfacePoint p = at(made, 0.2F, 0.3F);
  constexpr float kStep = 2e-3F;
  // From the change of coordinates along each edge to derivatives by u and v.
  const auto change = [&](float d1, float d2) {
    const SurfacePoint a = at(made, 0.2F - d1, 0.3F - d2);
    const SurfacePoint b = at(made, 0.2F + d1, 0.3F + d2);
    const Vec2 d = b.uv - a.uv;
    EXPECT_LT(length(b.ns - a.ns - p.dndu * d.x - p.dndv * d.y), 1e-5F);
    EXPECT_GT(length(b.ns - a.ns), 1e-4F);
  };
  change(kStep, 0.F);
  change(0.F, kStep);
}

TEST_F(TriangleMeshTest, TangentsTurnTheDerivatives) {
  auto mesh = triangle();
  mesh->tangents = points({1, 1, 0, 1, 1, 0, 1, 1, 0});
  const SurfacePoint p = at(make(mesh), 0.2F, 0.3F);
  const Vec3 expected = normalize(Vec3(1, 1, 0) - p.ng * dot(Vec3(1, 1, 0), p.ng));
  EXPECT_GT(dot(normalize(p.dpdu), expected), 0.9999F);
  EXPECT_NEAR(dot(p.dpdu, p.ng), 0.F, 1e-5F);
}

TEST_F(TriangleMeshTest, TheSignOfTangentsSaysWhereAcrossIsInMirrorImagesToo) {
  Mat4 mirror;
  mirror.setScale(Vec3d(-1, 1, 1));
  for (const bool reversed : {false, true}) {
    for (const int sign : {1, -1}) {
      auto mesh = triangle();
      mesh->normals = points({0, -0.4472136F, 0.8944272F, 0, -0.4472136F, 0.8944272F,  //
                              0, -0.4472136F, 0.8944272F});
      mesh->tangents = points({1, 0, 0, 1, 0, 0, 1, 0, 0});
      mesh->handedness.assign(3, static_cast<std::int8_t>(sign));
      const Vec3 plain = at(make(mesh, {}, reversed), 0.2F, 0.3F).dpdv;
      const Vec3 mirrored = at(make(mesh, mirror, reversed), 0.2F, 0.3F).dpdv;
      // The normal x tangent, as the file has the normal.
      EXPECT_GT(static_cast<float>(sign) * dot(plain, Vec3(0.F, 2.F, 1.F)), 0.F) << sign;
      EXPECT_LT(length(normalize(mirrored) - normalize(Vec3(-plain.x, plain.y, plain.z))), 1e-5F);
    }
  }
}

TEST_F(TriangleMeshTest, TrianglesWithoutAreaGiveFiniteFrames) {
  for (const Vec3& last : {Vec3(4, 0, 0), Vec3(0, 0, 0), Vec3(1e-25F, 2e-25F, 0)}) {
    auto mesh = triangle();
    mesh->positions[2] = last;
    const SurfacePoint p = at(make(mesh), 0.2F, 0.3F);
    EXPECT_NEAR(length(p.ng), 1.F, 1e-5F);
    EXPECT_TRUE(is_finite(p.dpdu) && is_finite(p.dpdv));
    EXPECT_GT(length(p.dpdu), 0.F);
  }
}

TEST_F(TriangleMeshTest, TinyAndHugeTrianglesHaveNormals) {
  for (const double size : {1e-18, 1e11}) {
    Mat4 scale;
    scale.setScale(size);
    const SurfacePoint p = at(make(triangle(), scale), 0.2F, 0.3F);
    EXPECT_GT(dot(p.ng, normalize(Vec3(0.F, -0.5F, 1.F))), 0.9999F) << size;
  }
}

TEST_F(TriangleMeshTest, UniquelyOwnedMeshIsPlacedInItsOwnMemory) {
  auto mesh = triangle();
  mesh->positions.reserve(8);
  const Vec3* memory = mesh->positions.data();
  Mat4 move;
  move[3][0] = 5.0;
  std::shared_ptr<const desc::Mesh> only = std::move(mesh);
  const TriangleMesh made = make(std::move(only), move);
  EXPECT_EQ(made.positions(), memory);
  EXPECT_EQ(made.positions()[1].x, 7.F);
}

TEST_F(TriangleMeshTest, SharedMeshIsLeftAlone) {
  const std::shared_ptr<const desc::Mesh> mesh = triangle();
  Mat4 move;
  move[3][0] = 5.0;
  const TriangleMesh made = make(mesh, move);
  EXPECT_EQ(mesh->positions[1].x, 2.F);
  EXPECT_EQ(made.positions()[1].x, 7.F);
  EXPECT_EQ(made.triangles(), mesh->indices.data());
}

TEST_F(TriangleMeshTest, BadIndicesAndVerticesAreLocatedErrors) {
  auto mesh = triangle();
  mesh->indices.emplace_back(0, 3, 1);
  EXPECT_EQ(error_of(mesh), "scene.pbrt:7:1: triangle 1 uses vertex 3 of a mesh with 3 vertices");
  mesh = triangle();
  mesh->positions[1].y = NAN;
  EXPECT_EQ(error_of(mesh), "scene.pbrt:7:1: vertex 1 of the mesh is not finite");
  mesh = triangle();
  mesh->positions[2].z = -1e18F;
  EXPECT_EQ(error_of(mesh),
            "scene.pbrt:7:1: vertex 2 of the mesh has coordinates of 1e+18, but no "
            "more than 6e+17 can be rendered: scale the scene down");
}

/// Their volume with the origin of a ray is no float: they would cast no shadow.
TEST_F(TriangleMeshTest, TrianglesTooLargeForTheTriangleTestAreLocatedErrors) {
  auto mesh = triangle();
  for (Vec3& p : mesh->positions) p *= 1e13F;
  EXPECT_EQ(error_of(mesh),
            "scene.pbrt:7:1: triangle 0 of the mesh is too large to be traced in "
            "single precision: scale the scene down, or use a disk, which may be "
            "larger");
  mesh = triangle();
  for (Vec3& p : mesh->positions) p += Vec3(1e17F, 0.F, 0.F);
  EXPECT_EQ(error_of(mesh), "") << "far away, but small";
}

TEST_F(TriangleMeshTest, AttributesOfTheWrongSizeAreDroppedWithAWarning) {
  auto mesh = triangle();
  mesh->normals = points({0, 0, -1});
  const SurfacePoint p = at(make(mesh), 0.2F, 0.3F);
  EXPECT_GT(p.ns.z, 0.5F);
  EXPECT_EQ(warnings_.count(), 1U);
}

TEST_F(TriangleMeshTest, PointsOfHugeTrianglesLieOnThem) {
  auto mesh = triangle();
  mesh->positions = points({-3e5F, -2e5F, 1e5F, 4e5F, 1e5F, -2e5F, 1e5F, 3e5F, 2e5F});
  const TriangleMesh made = make(mesh);
  EXPECT_GT(made.plane_error(), 0.F);
  Rng rng(3);
  for (int i = 0; i < 1000; ++i) {
    const float b1 = rng.next() * 0.5F;
    const float b2 = rng.next() * 0.5F;
    const SurfacePoint p = at(made, b1, b2);
    const double distance = made.plane_distance(0, Vec3d(p.p), Vec3d(p.ng));
    const double rounding = 0x1p-24 * (std::abs(p.p.x) + std::abs(p.p.y) + std::abs(p.p.z));
    EXPECT_LE(std::abs(distance), rounding + 1e-3);
  }
}

}  // namespace
}  // namespace ajar
