#include <algorithm>

#include "scene/material/inputs.h"

namespace ajar {
namespace {

constexpr WarningKind kOutOfRange{Effect::Surface,
                                  "colours of materials are out of range: clamped"};

/// Rounding on the way from a file does not count.
bool is_near_range(const ParameterSpec& spec, float lane) {
  constexpr double kRounding = 1e-3;
  return lane >= spec.minimum - kRounding && lane <= spec.maximum + kRounding;
}

/// A surface would reflect more light than it gets, or less than none.
void warn_of_clamped_colors(const desc::Material& description, const desc::Model& model,
                            Warnings& warnings) {
  for (const ParameterSpec& spec : model.parameters) {
    if (spec.type != ParameterType::Color || !spec.textured) continue;
    const auto* color = std::get_if<Vec3>(&description.node.get(spec.name));
    if (color == nullptr) continue;
    if (is_near_range(spec, color->x) && is_near_range(spec, color->y) &&
        is_near_range(spec, color->z)) {
      continue;
    }
    warnings.add(kOutOfRange, description.where,
                 "\"" + spec.name + "\" of a " + model.name + " material must be " +
                     range_text(spec) + ": clamped");
  }
}

}  // namespace

std::unique_ptr<Material> make_material(const desc::Material& description,
                                        const TextureList& textures, const MaterialList& made,
                                        Warnings& warnings) {
  const std::vector<MaterialModel>& models = material_models();
  const auto model = std::find_if(
      models.begin(), models.end(),
      [&](const MaterialModel& registered) { return description.node.is(registered.model.name); });
  if (model == models.end()) throw SceneError(description.where, "this material has no model");
  warn_of_clamped_colors(description, model->model, warnings);
  std::unique_ptr<Material> material =
      model->make(MaterialInputs(description, textures, made, warnings));
  material->name = description.name;
  // A mix inherits the relief of its first part, unless it has one of its own.
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
