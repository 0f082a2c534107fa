#include "import/tungsten/transforms.h"

#include <gtest/gtest.h>

#include "import/tungsten/import_test_support.h"

namespace ajar::tungsten {
namespace {

Mat4 transform_in(const std::string& text) {
  std::string json = text;
  for (char& c : json) c = c == '\'' ? '"' : c;
  desc::SceneDesc scene;
  Warnings warnings;
  FileAccess files("", {}, warnings);
  const Context context{scene, warnings, files};
  const Mat4 result = transform_of(context, LocatedJson::parse(json, {.name = "t.json"}));
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  return result;
}

TEST(Transforms, ScaleThenRotateThenMove) {
  const Mat4 m =
      transform_in("{'position': [1, 2, 3], 'scale': [2, 3, 4], 'rotation': [0, 0, 90]}");
  expect_near(moved(m, {1, 0, 0}), {1, 4, 3});
  expect_near(moved(m, {0, 1, 0}), {-2, 2, 3});
  expect_near(moved(m, {0, 0, 1}), {1, 2, 7});
}

TEST(Transforms, TurnAroundZThenXThenYAndAroundYTheOtherWay) {
  // From the second row of the formula for "rotation", written out: Tungsten,
  // src/core/math/Mat4f.cpp.
  expect_near(moved(transform_in("{'rotation': [90, 0, 0]}"), {0, 1, 0}), {0, 0, 1});
  expect_near(moved(transform_in("{'rotation': [0, 90, 0]}"), {1, 0, 0}), {0, 0, 1});
  expect_near(moved(transform_in("{'rotation': [90, 0, 90]}"), {1, 0, 0}), {0, 0, 1});
  expect_near(moved(transform_in("{'rotation': [90, 90, 0]}"), {0, 1, 0}), {-1, 0, 0});
}

TEST(Transforms, MatricesAreWrittenRowByRowForColumnVectors) {
  const Mat4 m = transform_in("[0, -2, 0, 5,  2, 0, 0, 6,  0, 0, 2, 7,  0, 0, 0, 1]");
  expect_near(moved(m, {1, 0, 0}), {5, 8, 7});
  expect_near(moved(m, {0, 1, 0}), {3, 6, 7});
}

TEST(Transforms, LookAlongZWithYUpAndAreRightHanded) {
  const Mat4 m = transform_in("{'position': [0, 0, 5], 'look_at': [0, 0, 0], 'up': [0, 1, 0]}");
  expect_near(moved(m, {0, 0, 1}), {0, 0, 4});
  expect_near(moved(m, {0, 1, 0}), {0, 1, 5});
  expect_near(moved(m, {1, 0, 0}), {-1, 0, 5});
  EXPECT_FALSE(swaps_handedness(m));
}

TEST(Transforms, KeepTheDirectionOfTheNamedAxis) {
  for (const char* name : {"x_axis", "y_axis", "z_axis", "up"}) {
    const Mat4 m = transform_in(std::string("{'") + name + "': [1, 2, 2]}");
    const int axis = name[0] == 'x' ? 0 : name[0] == 'z' ? 2 : 1;
    const Vec3d a = axis_of(m, axis);
    expect_near(Vec3(a), Vec3(1.F, 2.F, 2.F) / 3.F);
    EXPECT_NEAR(axis_of(m, 0).cross(axis_of(m, 1)).dot(axis_of(m, 2)), 1.0, 1e-12) << name;
  }
}

TEST(Transforms, WithoutScaleAreFrames) {
  const Mat4 m = without_scale(transform_in("{'scale': [2, 0, 4], 'position': [1, 2, 3]}"), true);
  expect_near(moved(m, {1, 1, 1}), {2, 3, 4});
  EXPECT_TRUE(is_invertible(m));
  EXPECT_FALSE(is_invertible(transform_in("{'scale': [2, 0, 4]}")));
  EXPECT_TRUE(is_invertible(transform_in("{'scale': 1e-10}")));
}

TEST(Transforms, RefuseInvalidOnes) {
  EXPECT_THROW(transform_in("[1, 2, 3]"), SceneError);
  EXPECT_THROW(transform_in("7"), SceneError);
  EXPECT_THROW(transform_in("{'position': [1, 2]}"), SceneError);
  EXPECT_THROW(transform_in("{'position': [1, 2, 1e60]}"), SceneError);
}

}  // namespace
}  // namespace ajar::tungsten
