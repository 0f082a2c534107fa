#include "import/pbrt/materials.h"

#include <algorithm>

#include "import/pbrt/material_names.h"
#include "import/pbrt/node_reader.h"
#include "scene/desc/models.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kStandIn{Effect::Surface, "materials are not supported: matte ones stand in"};
constexpr WarningKind kNoSubsurface{
    Effect::Surface, "disney materials have subsurface scattering, which is not supported"};

/// Warns of what pbrt's disney material has and ours has not.
void check_subsurface(const SourceLocation& where, const TextureParameters& p) {
  const std::optional<desc::Value> distance = p.find_spectrum("scatterdistance");
  if (!distance || *distance == desc::Value(Vec3(0.F))) return;
  p.context().warnings.add(
      kNoSubsurface, where,
      "disney: \"scatterdistance\" (subsurface scattering) is not supported: taken as 0");
}

/// Diffuse, with the nearest thing to a colour.
desc::Node stand_in(const SourceLocation& where, const StandIn& known, const TextureParameters& p) {
  const std::string type(known.type);
  p.context().warnings.add(
      kStandIn, where, "material \"" + type + "\" is not supported: a matte one stands in", type);
  const std::optional<desc::Value> color =
      known.color.empty() ? std::nullopt : p.find_spectrum(known.color);
  p.accept({"bsdffile", "sigma_a", "sigma_s", "eumelanin", "pheomelanin", "eta", "beta_m", "beta_n",
            "alpha", "name", "scale", "Kr", "Kt", "g", "mfp", "uroughness", "vroughness",
            "remaproughness"});
  return desc::material_node("diffuse", {{"reflectance", color.value_or(Vec3(known.fallback))}});
}

/// Whether pbrt reads "bumpmap" for this material.
bool can_be_bumpy(const desc::Node& node) { return !node.is("interface") && !node.is("mix"); }

}  // namespace

desc::MaterialId MaterialTable::part(const SourceLocation& where, const std::string& type,
                                     std::string_view parameter,
                                     const TextureParameters& parameters) const {
  const std::optional<std::string> name = parameters.text(parameter);
  if (!name) {
    throw SceneError(where,
                     "a " + type + " material needs \"string " + std::string(parameter) + "\"");
  }
  return named(where, *name)->id;
}

desc::Node MaterialTable::make_node(const SourceLocation& where, const std::string& type,
                                    const TextureParameters& parameters) const {
  if (const StandIn* known = find_stand_in(type)) return stand_in(where, *known, parameters);
  const desc::Model* model = model_of_type(desc::ModelKind::Material, material_names(), type);
  if (model == nullptr) {
    std::vector<std::string> types = types_of(desc::ModelKind::Material, material_names());
    for (std::string& known : stand_in_types()) types.push_back(std::move(known));
    fail_unknown(where, "material", type, types);
  }
  const desc::Node node = NodeReader(where, parameters)
                              .with_materials([&](std::string_view parameter) {
                                return part(where, type, parameter, parameters);
                              })
                              .read(*model, find_theirs(material_names(), type));
  if (type == "disney") check_subsurface(where, parameters);
  return node;
}

desc::MaterialId MaterialTable::build(const SourceLocation& where, const std::string& type,
                                      const std::string& name,
                                      const TextureParameters& parameters) {
  desc::Material material;
  material.name = name;
  material.where = where;
  material.node = make_node(where, type, parameters);
  if (can_be_bumpy(material.node)) {
    // A bump that is the same everywhere is none.
    const std::optional<desc::Value> bump = parameters.find_number("bumpmap");
    if (bump && std::holds_alternative<desc::TextureRef>(*bump)) {
      material.bump = std::get<desc::TextureRef>(*bump).id;
    }
  }
  context_.scene.materials.push_back(std::move(material));
  return static_cast<desc::MaterialId>(context_.scene.materials.size()) - 1;
}

MaterialPointer MaterialTable::make(const SourceLocation& where, const std::string& type,
                                    std::shared_ptr<const ParameterList> parameters,
                                    const std::string& name) {
  const desc::MaterialId id =
      build(where, type, name, TextureParameters(context_, textures_, *parameters));
  parameters->report_unused(context_.warnings);
  return std::make_shared<const MaterialChoice>(
      MaterialChoice{id, type, name, std::move(parameters)});
}

void MaterialTable::make_named(const SourceLocation& where, const std::string& name,
                               std::shared_ptr<const ParameterList> parameters) {
  const std::optional<std::string> type = parameters->get_string("type");
  if (!type) throw SceneError(where, "MakeNamedMaterial needs \"string type\"");
  names_.set(name, make(where, *type, std::move(parameters), name));
}

MaterialPointer MaterialTable::named(const SourceLocation& where, const std::string& name) const {
  if (const MaterialPointer* found = names_.find(name)) return *found;
  throw SceneError(where, unknown_name_message("named material", name, names_.names()));
}

desc::MaterialId MaterialTable::for_shape(const SourceLocation& where, MaterialPointer current,
                                          const ParameterList& shape) {
  if (!current) {
    if (!default_) default_ = make(where, "matte", std::make_shared<const ParameterList>());
    current = default_;
  }
  if (shape.all_used()) return current->id;
  const std::size_t used = shape.used_count();
  const desc::MaterialId variant =
      build(where, current->type, current->name,
            TextureParameters(context_, textures_, shape, current->parameters.get()));
  const std::vector<desc::Material>& materials = context_.scene.materials;
  // What the shape itself reads, too, was used before, but may make another material.
  if (shape.used_count() > used ||
      materials.back().node != materials[static_cast<std::size_t>(current->id)].node) {
    return variant;
  }
  context_.scene.materials.pop_back();  // the shape's parameters were not about the material
  return current->id;
}

}  // namespace ajar::pbrt
