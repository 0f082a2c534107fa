#include "import/mitsuba/materials.h"

#include <algorithm>

#include "core/printable_text.h"
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

}  // namespace

Surface MaterialTable::make(const Element& bsdf) {
  if (const auto known = made_.find(&bsdf); known != made_.end()) return known->second;
  Arguments arguments(context_, bsdf);
  const MaterialInputs in{arguments, *this, textures_};
  const MaterialPlugin* plugin = find_material_plugin(bsdf.type);
  const Surface surface = plugin == nullptr ? stand_in(in) : plugin->make(in);
  check_depth(surface.material, bsdf.where);
  return made_[&bsdf] = surface;
}

void MaterialTable::check_depth(desc::MaterialId id, const SourceLocation& where) {
  constexpr int kDeepestMixes = 100;
  const auto depth_of = [&](desc::MaterialId part) {
    return depths_.at(static_cast<std::size_t>(part));
  };
  // Parts are made before their owners.
  while (depths_.size() < context_.scene.materials.size()) {
    const desc::Node& node = context_.scene.materials[depths_.size()].node;
    depths_.push_back(node.is("mix") ? 1 + std::max(depth_of(node.material("first")),
                                                    depth_of(node.material("second")))
                                     : 0);
  }
  if (depth_of(id) > kDeepestMixes) throw SceneError(where, "bsdfs are nested too deeply");
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
  return {add_shared(interface_,
                     desc::material_node("interface", {{"counted", context_.counts_boundaries}}))};
}

desc::MaterialId MaterialTable::black() { return diffuse(0.F).material; }

}  // namespace ajar::mitsuba
