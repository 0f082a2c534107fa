#include <algorithm>

#include "scene/material/inputs.h"

namespace ajar {

std::unique_ptr<Material> make_material(const desc::Material& description,
                                        const TextureList& textures, const MaterialList& made,
                                        Warnings& warnings) {
  const std::vector<MaterialModel>& models = material_models();
  const auto model = std::find_if(
      models.begin(), models.end(),
      [&](const MaterialModel& registered) { return description.node.is(registered.model.name); });
  if (model == models.end()) throw SceneError(description.where, "this material has no model");
  std::unique_ptr<Material> material =
      model->make(MaterialInputs(description, textures, made, warnings));
  material->name = description.name;
  // That of a mix is that of its first part, unless it has one of its own.
  if (description.has_relief()) material->relief = Relief(description, textures);
  return material;
}

MaterialList build_materials(const desc::SceneDesc& scene, const TextureList& textures,
                             Warnings& warnings) {
  MaterialList materials;
  materials.reserve(scene.materials.size());
  for (const desc::Material& description : scene.materials) {
    materials.push_back(make_material(description, textures, materials, warnings));
  }
  return materials;
}

}  // namespace ajar
