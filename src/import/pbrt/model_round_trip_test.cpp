// Every model of ours can be written as pbrt and read back: those that pbrt has by its names,
// others by their own.
#include <gtest/gtest.h>

#include "import/pbrt/import_test_support.h"
#include "import/pbrt/pbrt_writer.h"
#include "scene/desc/models.h"
#include "scene/testing/another_value.h"

namespace ajar {
namespace {

using desc::ModelKind;
using desc::Node;

/// The scene after it was written and read.
desc::SceneDesc there_and_back(const desc::SceneDesc& scene) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "scene.pbrt").string();
  write_pbrt(scene, file);
  Warnings warnings;
  desc::SceneDesc back = import_pbrt(file, warnings);
  for (const std::string& message : warnings.messages()) {
    EXPECT_NE(message.find("there are no shapes"), std::string::npos) << message;
  }
  return back;
}

TEST(ModelRoundTrip, KeepsEveryParameterOfEveryMaterial) {
  for (const desc::Model* model : desc::models(ModelKind::Material)) {
    desc::SceneDesc scene;
    scene.materials.emplace_back().node = desc::material_node("mirror");
    Node node(*model);
    for (const ParameterSpec& spec : model->parameters) {
      if (node.matters(spec)) node.set(spec.name, testing::another_value(spec));
    }
    scene.materials.emplace_back().node = node;
    EXPECT_EQ(there_and_back(scene).materials.at(1).node, node) << model->name;
  }
}

/// Uses a texture as a number, or as a colour.
desc::SceneDesc with_texture(const Node& node, bool as_number) {
  desc::SceneDesc scene;
  scene.textures.emplace_back().node = node;
  scene.materials.emplace_back().node =
      desc::material_node("diffuse", {{as_number ? "sigma" : "reflectance", desc::TextureRef{0}}});
  return scene;
}

/// With every value of the parameter that others depend on.
std::vector<Node> variants(const desc::Model& model) {
  std::vector<Node> nodes;
  for (const ParameterSpec& spec : model.parameters) {
    if (spec.name != "mapping") continue;
    for (const std::string& mapping : spec.choices)
      nodes.emplace_back(model).set("mapping", mapping);
  }
  if (nodes.empty()) nodes.emplace_back(model);
  return nodes;
}

TEST(ModelRoundTrip, KeepsEveryParameterOfEveryTexture) {
  for (const desc::Model* model : desc::models(ModelKind::Texture)) {
    for (Node node : variants(*model)) {
      for (const ParameterSpec& spec : model->parameters) {
        if (spec.name == "mapping" || !node.matters(spec)) continue;
        node.set(spec.name, testing::another_value(spec));
      }
      for (const bool as_number : {false, true}) {
        const desc::SceneDesc scene = with_texture(node, as_number);
        const Node back = there_and_back(scene).textures.at(0).node;
        // Numbers are written as numbers.
        for (std::size_t i = 0; i < node.values().size(); ++i) {
          const ParameterSpec& spec = model->parameters[i];
          if (as_number && spec.type == ParameterType::Color) {
            EXPECT_EQ(back.color(spec.name), Vec3(node.color(spec.name).x)) << model->name;
          } else if (spec.type == ParameterType::Transform) {
            EXPECT_TRUE(
                back.transform(spec.name).equalWithAbsError(node.transform(spec.name), 1e-12))
                << model->name;
          } else {
            EXPECT_EQ(back.values()[i], node.values()[i]) << model->name << ' ' << spec.name;
          }
        }
      }
    }
  }
}

TEST(ModelRoundTrip, KeepsEveryParameterOfEveryLight) {
  for (const desc::Model* model : desc::models(ModelKind::Light)) {
    desc::SceneDesc scene;
    Node node(*model);
    for (const ParameterSpec& spec : model->parameters)
      node.set(spec.name, testing::another_value(spec));
    scene.lights.emplace_back().node = node;
    EXPECT_EQ(there_and_back(scene).lights.at(0).node, node) << model->name;
  }
}

/// Something of every shape can be seen: its numbers grow from one parameter to the next.
Node visible_shape(const desc::Model& model) {
  Node node(model);
  float value = 0.125F;
  for (const ParameterSpec& spec : model.parameters) {
    value += 0.125F;
    if (spec.type == ParameterType::Float) {
      node.set(spec.name, value);
    } else if (spec.type == ParameterType::Point) {
      node.set(spec.name, Vec3(value));
    } else {
      node.set(spec.name, testing::another_value(spec));
    }
  }
  if (model.name == "disk") node.set("inner_radius", 0.0625F);
  if (model.name == "sphere") node.set("z_min", -0.125F);
  return node;
}

TEST(ModelRoundTrip, KeepsEveryParameterOfEveryShape) {
  for (const desc::Model* model : desc::models(ModelKind::Shape)) {
    desc::SceneDesc scene;
    scene.shapes.emplace_back().node = visible_shape(*model);
    scene.materials.emplace_back().node = desc::material_node("diffuse");
    scene.shapes.back().material = 0;
    const desc::SceneDesc back = there_and_back(scene);
    ASSERT_EQ(back.shapes.size(), 1U) << model->name;
    EXPECT_TRUE(back.shapes[0].node.is(model->name)) << model->name;
    EXPECT_EQ(desc::hash(back), desc::hash(scene)) << model->name;
  }
}

TEST(ModelRoundTrip, KeepsEveryParameterOfEveryEmission) {
  for (const desc::Model* model : desc::models(ModelKind::Emission)) {
    desc::SceneDesc scene;
    Node node(*model);
    for (const ParameterSpec& spec : model->parameters)
      node.set(spec.name, testing::another_value(spec));
    scene.materials.emplace_back().node = desc::material_node("diffuse");
    scene.shapes.emplace_back().node = desc::shape_node("sphere");
    scene.shapes.back().material = 0;
    scene.shapes.back().emission = desc::Emission{{}, node};
    const desc::SceneDesc back = there_and_back(scene);
    ASSERT_EQ(back.shapes.size(), 1U) << model->name;
    EXPECT_EQ(back.shapes[0].emission->node, node) << model->name;
  }
}

TEST(ModelRoundTrip, KeepsDefaults) {
  for (const char* name : {"dielectric", "conductor", "coated_diffuse", "composite"}) {
    desc::SceneDesc scene;
    scene.materials.emplace_back().node = desc::material_node(name, {{"roughness", 0.25F}});
    const Node back = there_and_back(scene).materials.at(0).node;
    EXPECT_EQ(back.number("roughness"), 0.25F) << name;
    EXPECT_EQ(back.number("roughness_v"), 0.25F) << name;
  }
}

}  // namespace
}  // namespace ajar
