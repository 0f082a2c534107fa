#include "import/pbrt/material_names.h"
#include "import/pbrt/writer_context.h"
#include "scene/desc/models.h"

namespace ajar::pbrt {
namespace {

/// pbrt has the metal without its coat.
desc::Node metal_in_pbrt(const desc::Node& coated) {
  desc::Node metal = desc::material_node("conductor");
  const auto set = [](desc::Node& node, const char* name, const desc::Value& value) {
    if (!std::holds_alternative<std::monostate>(value)) node.set(name, value);
  };
  for (const char* name :
       {"eta", "k", "reflectance", "roughness", "roughness_v", "roughness_scale"}) {
    set(metal, name, coated.get(name));
  }
  const Substitutes substitutes = substitutes_of_material(metal);
  desc::Node result = desc::material_node("conductor");
  for (const char* name : {"eta", "k", "roughness", "roughness_v", "roughness_scale"}) {
    const auto told = substitutes.find(name);
    set(result, name, told == substitutes.end() ? metal.get(name) : told->second);
  }
  return result;
}

void write_material(WriterContext& context, std::size_t i) {
  const desc::Material& material = context.scene.materials[i];
  const bool is_coated_metal = material.node.is("coated_conductor");
  const desc::Node node = is_coated_metal ? metal_in_pbrt(material.node) : material.node;
  const ModelName* names = find_ours(material_names(), node.model().name);
  context.out.line("MakeNamedMaterial").quoted(context.material_names[i]);
  context.out.parameter("string type", names == nullptr ? node.model().name : names->theirs);
  const Substitutes substitutes =
      names == nullptr || is_coated_metal ? Substitutes() : substitutes_of_material(node);
  write_parameters(context, node, names, false, substitutes);
  if (is_coated_metal) {
    ++context.unknown_models[material.node.model().name];
    write_own_words(context, material.node);
  }
  context.reference("bumpmap", material.bump);
  const desc::NormalMap& normals = material.normal_map;
  if (normals.texture == desc::kNone) return;
  ++context.unknown_parameters["normal_map"];
  context.reference("normal_map", normals.texture);
  context.out.parameter("float normal_strength", normals.strength);
  context.out.parameter("bool normal_right_handed", normals.right_handed ? "true" : "false");
}

}  // namespace

void write_materials(WriterContext& context) {
  for (std::size_t i = 0; i < context.scene.materials.size(); ++i) write_material(context, i);
}

}  // namespace ajar::pbrt
