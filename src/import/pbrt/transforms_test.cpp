#include "import/common/transforms.h"

#include <gtest/gtest.h>

#include <cstring>

#include "import/pbrt/import_test_support.h"

namespace ajar {
namespace {

void expect_near(const Vec3& actual, const Vec3& expected, float tolerance = 1e-5F) {
  EXPECT_NEAR(length(actual - expected), 0.F, tolerance)
      << actual.x << " " << actual.y << " " << actual.z;
}

/// Transform of a sphere after these directives.
Mat4 placed(const std::string& directives) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(world(directives), warnings);
  EXPECT_EQ(warnings.count(), 0U) << directives;
  return scene.shapes.back().to_world;
}

TEST(PbrtTransforms, TheLastDirectiveIsAppliedFirst) {
  const Mat4 m = placed("Translate 10 0 0 Scale 2 3 4");
  expect_near(transform_point(m, {1.F, 1.F, 1.F}), {12.F, 3.F, 4.F});
}

TEST(PbrtTransforms, RotationIsCounterClockwiseAroundItsAxis) {
  expect_near(transform_point(placed("Rotate 90 0 0 1"), {1.F, 0.F, 0.F}), {0.F, 1.F, 0.F});
  expect_near(transform_point(placed("Rotate 90 0 2 0"), {0.F, 0.F, 1.F}), {1.F, 0.F, 0.F});
  expect_near(transform_point(placed("Rotate 90 1 0 0"), {0.F, 1.F, 0.F}), {0.F, 0.F, 1.F});
  expect_near(transform_point(placed("Rotate 120 1 1 1"), {1.F, 0.F, 0.F}), {0.F, 1.F, 0.F});
}

TEST(PbrtTransforms, MatricesAreWrittenColumnByColumn) {
  const Mat4 m = placed("Transform [1 0 0 0  0 1 0 0  0 0 1 0  7 8 9 1]");
  expect_near(transform_point(m, {0.F, 0.F, 0.F}), {7.F, 8.F, 9.F});
  const Mat4 c = placed("Scale 2 2 2 ConcatTransform [1 0 0 0  0 1 0 0  0 0 1 0  7 8 9 1]");
  expect_near(transform_point(c, {0.F, 0.F, 0.F}), {14.F, 16.F, 18.F});
  EXPECT_EQ(placed("Scale 2 2 2 Identity"), Mat4());
}

TEST(PbrtTransforms, LookAtPutsTheCameraAtTheEyeLookingAlongZ) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      "LookAt 1 2 3  1 2 13  0 1 0 Camera \"perspective\" WorldBegin Shape \"sphere\" WorldEnd",
      warnings);
  const Mat4& m = scene.camera.to_world;
  expect_near(transform_point(m, {0.F, 0.F, 0.F}), {1.F, 2.F, 3.F});
  expect_near(transform_vector(m, {0.F, 0.F, 1.F}), {0.F, 0.F, 1.F});
  expect_near(transform_vector(m, {0.F, 1.F, 0.F}), {0.F, 1.F, 0.F});
  // Left-handed, as pbrt: looking along +z with y up, x is to the right.
  expect_near(transform_vector(m, {1.F, 0.F, 0.F}), {1.F, 0.F, 0.F});
}

TEST(PbrtTransforms, LookAtKeepsUpInTheVerticalPlane) {
  const std::optional<Mat4> m = look_at({4.0, 3.0, -2.0}, {0.0, 1.0, 0.0}, {0.0, 2.0, 0.0});
  ASSERT_TRUE(m);
  const Mat4 to_world = *inverse(*m);
  const Vec3 up = transform_vector(to_world, {0.F, 1.F, 0.F});
  const Vec3 right = transform_vector(to_world, {1.F, 0.F, 0.F});
  const Vec3 forward = transform_vector(to_world, {0.F, 0.F, 1.F});
  EXPECT_GT(up.y, 0.5F);
  EXPECT_NEAR(right.y, 0.F, 1e-6F);
  expect_near(forward, normalize(Vec3(-4.F, -2.F, 2.F)));
  expect_near(cross(up, forward), right);
}

TEST(PbrtTransforms, DegenerateOnesAreLocatedErrors) {
  EXPECT_EQ(
      error_of("\nLookAt 0 0 0 0 0 0 0 1 0"),
      "test.pbrt:2:1: this LookAt has no viewing direction, or one that is parallel to \"up\"");
  EXPECT_NE(error_of("LookAt 0 0 0 0 1 0 0 1 0").find("parallel"), std::string::npos);
  EXPECT_NE(error_of("Rotate 30 0 0 0").find("test.pbrt:1:1"), std::string::npos);
  EXPECT_NE(
      error_of("Scale 1e300 1 1 Scale 1e300 1 1").find("1:17: the current transform is not finite"),
      std::string::npos);
  EXPECT_NE(error_of("Scale 0 1 1 Camera \"perspective\"").find("cannot be inverted"),
            std::string::npos);
}

TEST(PbrtTransforms, BlocksRestoreTheTransform) {
  Warnings warnings;
  const desc::SceneDesc scene =
      import_with(world("TransformBegin Translate 1 0 0 Shape \"sphere\" TransformEnd "
                        "AttributeBegin Translate 2 0 0 Shape \"sphere\" AttributeEnd"),
                  warnings);
  ASSERT_EQ(scene.shapes.size(), 3U);
  EXPECT_EQ(scene.shapes[0].to_world[3][0], 1.0);
  EXPECT_EQ(scene.shapes[1].to_world[3][0], 2.0);
  EXPECT_EQ(scene.shapes[2].to_world, Mat4());
}

TEST(PbrtTransforms, CoordinateSystemsAreRemembered) {
  const Mat4 m =
      placed("Translate 1 2 3 CoordinateSystem \"here\" Scale 5 5 5 CoordSysTransform \"here\"");
  expect_near(transform_point(m, {0.F, 0.F, 0.F}), {1.F, 2.F, 3.F});
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      "Translate -4 0 0 Camera \"perspective\" WorldBegin CoordSysTransform \"camera\" Shape "
      "\"sphere\" WorldEnd",
      warnings);
  EXPECT_EQ(scene.shapes[0].to_world[3][0], 4.0);
  EXPECT_NE(error_of("CoordSysTransform \"x\"").find("unknown coordinate system \"x\""),
            std::string::npos);
}

TEST(PbrtTransforms, MotionIsReportedAndTheStartIsUsed) {
  const std::string moving = world(
      "ActiveTransform EndTime Translate 9 0 0 ActiveTransform StartTime Translate 3 0 0 "
      "ActiveTransform All");
  Warnings warnings;
  const desc::SceneDesc scene = import_with(moving, warnings);
  EXPECT_EQ(scene.shapes[0].to_world[3][0], 3.0);
  EXPECT_EQ(warnings.count(), 1U);
  EXPECT_NE(error_of("ActiveTransform Never").find("unknown ActiveTransform \"Never\""),
            std::string::npos);
}

TEST(RoundedInverse, OfTheInverseGivesTheSameBits) {
  for (int i = 1; i < 50; ++i) {
    const Mat4 m = *look_at({0.1 * i, 3.0, -2.0 * i}, {0.3, 1.0, 1e-3 * i}, {0.1, 2.0, 0.01 * i});
    const Mat4 first = *rounded_inverse(m);
    const Mat4 again = *rounded_inverse(*inverse(first));
    EXPECT_EQ(first, again) << i;
  }
  EXPECT_FALSE(rounded_inverse(scaling({1.0, 0.0, 1.0})));
}

TEST(ZTo, TurnsZIntoAnyDirection) {
  for (const Vec3d& d : {Vec3d(1.0, 2.0, 3.0), Vec3d(0.0, 0.0, -1.0), Vec3d(-1.0, 0.0, 0.0),
                         Vec3d(1e-20, 2e-20, 0.0)}) {
    const Mat4 m = *z_to(d);
    const Vec3 z = transform_vector(m, {0.F, 0.F, 1.F});
    EXPECT_NEAR((Vec3d(z) - d / d.length()).length(), 0.0, 1e-6);
    EXPECT_FALSE(swaps_handedness(m));
  }
  EXPECT_EQ(*z_to({0.0, 0.0, 5.0}), Mat4());
  EXPECT_FALSE(z_to({0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace ajar
