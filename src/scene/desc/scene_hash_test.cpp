#include <gtest/gtest.h>

#include <set>

#include "scene/desc/models.h"
#include "scene/desc/scene_desc.h"
#include "scene/testing/another_value.h"

/// The hash follows every parameter of every model.
namespace ajar::desc {
namespace {

/// A scene in which the node matters.
SceneDesc scene_with(ModelKind kind, const Node& node) {
  SceneDesc scene;
  scene.textures.emplace_back().node = kind == ModelKind::Texture ? node : texture_node("uv");
  const Node textured = material_node("diffuse", {{"reflectance", TextureRef{0}}});
  scene.materials.emplace_back().node = textured;
  scene.materials.emplace_back().node = kind == ModelKind::Material ? node : textured;
  scene.shapes.emplace_back().node = kind == ModelKind::Shape ? node : shape_node("sphere");
  scene.shapes.back().material = 1;
  scene.shapes.back().emission =
      Emission{{}, kind == ModelKind::Emission ? node : emission_node("area")};
  scene.lights.emplace_back().node = kind == ModelKind::Light ? node : light_node("point");
  return scene;
}

class SceneHashOf : public ::testing::TestWithParam<ModelKind> {};

TEST_P(SceneHashOf, ChangesWithEveryParameterThatMatters) {
  for (const Model* model : models(GetParam())) {
    const std::uint64_t plain = hash(scene_with(GetParam(), Node(*model)));
    EXPECT_EQ(hash(scene_with(GetParam(), Node(*model))), plain) << model->name;
    for (const ParameterSpec& spec : model->parameters) {
      Node node(*model);
      node.set(spec.name, ajar::testing::another_value(spec));
      const bool changed = hash(scene_with(GetParam(), node)) != plain;
      EXPECT_EQ(changed, node.matters(spec)) << model->name << ' ' << spec.name;
    }
  }
}

TEST_P(SceneHashOf, TellsModelsApart) {
  std::set<std::uint64_t> hashes;
  for (const Model* model : models(GetParam())) {
    EXPECT_TRUE(hashes.insert(hash(scene_with(GetParam(), Node(*model)))).second) << model->name;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, SceneHashOf, ::testing::ValuesIn(kModelKinds));

}  // namespace
}  // namespace ajar::desc
