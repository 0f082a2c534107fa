#include "import/mitsuba/materials.h"

#include "import/common/printable.h"
#include "import/mitsuba/material_plugins.h"
#include "import/mitsuba/plugin_types.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kMaterialStandIn{Effect::Surface,
                                       "materials are not supported: diffuse ones stand in"};

/// Diffuse, with the nearest thing to a colour.
Surface stand_in(const MaterialInputs& in) {
  const Element& element = in.arguments.element();
  in.context().warnings.add(kMaterialStandIn, element.where,
                            unknown_type_message(element) + ". A diffuse one stands in",
                            printable(element.type));
  desc::Value color = Vec3(0.5F);
  for (const char* name : {"reflectance", "diffuse_reflectance", "base_color"}) {
    if (const auto found = in.materials.textures().find_color(in.arguments, name)) color = *found;
  }
  in.arguments.accept_all();
  return {in.materials.add(element, desc::material_node("diffuse", {{"reflectance", color}}))};
}

/// By references any number could be within each other, all of which a relief has to pass.
void check_depth(const desc::SceneDesc& scene, desc::MaterialId id, const SourceLocation& where) {
  constexpr int kDeepestMixes = 100;
  for (int depth = 0;; ++depth) {
    const desc::Node& node = scene.materials[static_cast<std::size_t>(id)].node;
    if (!node.is("mix")) return;
    if (depth >= kDeepestMixes) throw SceneError(where, "bsdfs are nested too deeply");
    id = node.material("first");
  }
}

}  // namespace

Surface MaterialTable::make(const Element& bsdf) {
  if (const auto known = made_.find(&bsdf); known != made_.end()) return known->second;
  Arguments arguments(context_, bsdf);
  const MaterialInputs in{arguments, *this, textures_};
  const MaterialPlugin* plugin = find_material_plugin(bsdf.type);
  const Surface surface = plugin == nullptr ? stand_in(in) : plugin->make(in);
  check_depth(context_.scene, surface.material, bsdf.where);
  return made_[&bsdf] = surface;
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
