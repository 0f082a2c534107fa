#include "import/pbrt/material_names.h"
#include "import/pbrt/writer_context.h"

namespace ajar::pbrt {
namespace {

void write_material(WriterContext& context, std::size_t i) {
  const desc::Material& material = context.scene.materials[i];
  const ModelName* names = find_ours(material_names(), material.node.model().name);
  context.out.line("MakeNamedMaterial").quoted(context.material_names[i]);
  context.out.parameter("string type",
                        names == nullptr ? material.node.model().name : names->theirs);
  const Substitutes substitutes =
      names == nullptr ? Substitutes() : substitutes_of_material(material.node);
  write_parameters(context, material.node, names, false, substitutes);
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
