#include "scene/build/validate.h"

#include <gtest/gtest.h>

#include "scene/testing/quadrics.h"

namespace ajar {
namespace {

desc::SceneDesc one_sphere() {
  desc::SceneDesc scene;
  desc::Shape shape;
  shape.node = testing::sphere_node();
  shape.where = {std::make_shared<const std::string>("scene.pbrt"), 4, 2};
  scene.shapes.push_back(shape);
  return scene;
}

TEST(ValidateReferences, AcceptsScenesWithoutReferences) {
  EXPECT_NO_THROW(validate_references(one_sphere()));
}

TEST(ValidateReferences, MissingMaterialIsALocatedError) {
  desc::SceneDesc scene = one_sphere();
  scene.shapes[0].material = 0;
  try {
    validate_references(scene);
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_EQ(std::string(error.what()),
              "scene.pbrt:4:2: this refers to a material that does not exist");
  }
}

TEST(ValidateReferences, ShapesOfObjectsAreCheckedToo) {
  desc::SceneDesc scene = one_sphere();
  scene.objects.push_back({"object", {}, scene.shapes});
  scene.objects[0].shapes[0].alpha = 2;
  EXPECT_THROW(validate_references(scene), SceneError);
}

TEST(ValidateReferences, NegativeIdsOtherThanNoneAreRefused) {
  desc::SceneDesc scene = one_sphere();
  scene.shapes[0].inside = -2;
  EXPECT_THROW(validate_references(scene), SceneError);
}

TEST(DefaultMaterial, IsSharedByAllShapesWithoutOne) {
  desc::SceneDesc scene = one_sphere();
  scene.shapes.push_back(scene.shapes[0]);
  scene.objects.push_back({"object", {}, scene.shapes});
  add_default_material(scene);
  EXPECT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(scene.shapes[1].material, 0);
  EXPECT_EQ(scene.objects[0].shapes[0].material, 0);
  EXPECT_NO_THROW(validate_references(scene));
}

TEST(DefaultMaterial, IsNotAddedWithoutNeed) {
  desc::SceneDesc scene = one_sphere();
  scene.materials.emplace_back();
  scene.shapes[0].material = 0;
  add_default_material(scene);
  EXPECT_EQ(scene.materials.size(), 1U);
}

}  // namespace
}  // namespace ajar
