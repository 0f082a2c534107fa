// Every model of ours can be written as pbrt and read back: those that pbrt has by its names,
// others by their own.
#include <gtest/gtest.h>

#include "import/pbrt/import_test_support.h"
#include "import/pbrt/pbrt_writer.h"
#include "scene/desc/models.h"

namespace ajar {
namespace {

using desc::ModelKind;
using desc::Node;
using desc::Value;

/// A value that is not the default.
Value another_value(const ParameterSpec& spec) {
  switch (spec.type) {
    case ParameterType::Bool:
      return spec.default_value != "true";
    case ParameterType::Int:
      return std::get<int>(desc::default_value(spec)) + 1;
    case ParameterType::Float:
      return 0.375F;
    case ParameterType::Color:
    case ParameterType::Vector:
      return Vec3(0.125F, 0.375F, 0.625F);
    case ParameterType::Choice:
      return spec.choices.back();
    case ParameterType::Text:
      return "text";
    case ParameterType::File:
      return "/somewhere/picture.exr";
    case ParameterType::Material:
      return desc::MaterialRef{0};
    case ParameterType::Transform:
      break;
  }
  ADD_FAILURE() << spec.name;
  return {};
}

/// What the scene is after it was written and read.
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
    for (const ParameterSpec& spec : model->parameters) node.set(spec.name, another_value(spec));
    scene.materials.emplace_back().node = node;
    EXPECT_EQ(there_and_back(scene).materials.at(1).node, node) << model->name;
  }
}

TEST(ModelRoundTrip, KeepsWhatIsLeftOut) {
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
