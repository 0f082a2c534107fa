#include "import/mitsuba/materials.h"

#include "import/common/printable.h"
#include "import/mitsuba/material_plugins.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kMaterialStandIn{Effect::Surface,
                                       "materials are not supported: diffuse ones stand in"};

/// Diffuse, with the nearest thing to a colour.
Surface stand_in(const MaterialInputs& in) {
  const std::string& type = in.arguments.element().type;
  std::vector<std::string> known;
  for (const MaterialPlugin& plugin : material_plugins()) known.emplace_back(plugin.type);
  in.arguments.context().warnings.add(
      kMaterialStandIn, in.arguments.where(),
      unknown_name_message("bsdf", printable(type), known) + ". A diffuse one stands in",
      printable(type));
  desc::Value color = Vec3(0.5F);
  for (const char* name : {"reflectance", "diffuse_reflectance", "base_color"}) {
    if (const auto found = in.materials.textures().find_color(in.arguments, name)) color = *found;
  }
  in.arguments.accept_all();
  return {in.materials.add(in.arguments.element(),
                           desc::material_node("diffuse", {{"reflectance", color}}))};
}

}  // namespace

Surface MaterialTable::make(const Element& bsdf) {
  const auto [place, is_new] = made_.try_emplace(&bsdf, std::nullopt);
  if (!is_new) {
    if (!place->second) throw SceneError(bsdf.where, "this bsdf refers to itself");
    return *place->second;
  }
  Arguments arguments(context_, bsdf);
  const MaterialInputs in{arguments, *this, textures_};
  const MaterialPlugin* plugin = find_material_plugin(bsdf.type);
  const Surface surface = plugin == nullptr ? stand_in(in) : plugin->make(in);
  arguments.report_unused();
  made_[&bsdf] = surface;
  return surface;
}

desc::MaterialId MaterialTable::add(const Element& element, desc::Node node) {
  // Said outright, as formats must say it that have no "the same in all directions".
  if (node.has("roughness_v") && std::holds_alternative<std::monostate>(node.get("roughness_v"))) {
    node.set("roughness_v", node.get("roughness"));
  }
  context_.scene.materials.push_back(
      {.name = element.id, .where = element.where, .node = std::move(node)});
  return static_cast<desc::MaterialId>(context_.scene.materials.size()) - 1;
}

desc::MaterialId MaterialTable::add_shared(desc::MaterialId& id, desc::Node node) {
  if (id == desc::kNone) id = add(context_.document.scene, std::move(node));
  return id;
}

Surface MaterialTable::diffuse(float reflectance) {
  desc::MaterialId& id = diffuse_.try_emplace(reflectance, desc::kNone).first->second;
  const desc::MaterialId made =
      add_shared(id, desc::material_node("diffuse", {{"reflectance", Vec3(reflectance)}}));
  return {made, desc::kNone, reflectance > 0.F};
}

Surface MaterialTable::interface() {
  return {add_shared(interface_, desc::material_node("interface"))};
}

desc::MaterialId MaterialTable::black() { return diffuse(0.F).material; }

}  // namespace ajar::mitsuba
