#include "import/common/conductors.h"
#include "import/common/printable.h"
#include "import/mitsuba/refraction.h"
#include "import/mitsuba/roughness.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnknownConductor{Effect::Surface,
                                        "conductors have unknown names: copper stands in"};

desc::Node dielectric(const MaterialInputs& in, bool thin) {
  desc::Node node = desc::material_node("dielectric", {{"thin", thin}});
  node.set("eta", relative_index(in.arguments, "bk7"));
  node.set("reflectance", in.textures.color(in.arguments, "specular_reflectance", desc::Rgb(1.F)));
  node.set("transmittance",
           in.textures.color(in.arguments, "specular_transmittance", desc::Rgb(1.F)));
  return node;
}

ComplexIndex index_by_name(const MaterialInputs& in) {
  const std::string name = in.arguments.text("material", "Cu");
  if (const std::optional<ComplexIndex> index = conductor_named(name)) return *index;
  in.context().warnings.add(
      kUnknownConductor, in.where(),
      unknown_name_message("conductor", printable(name), conductor_names()) + ". Copper stands in",
      printable(name));
  return *conductor_named("Cu");
}

/// Sets "eta" and "k", both relative to the outside.
void set_index(const MaterialInputs& in, desc::Node& node) {
  const float outside = index_of_refraction(in.arguments, "ext_eta", "air");
  std::optional<desc::Value> eta = in.textures.find_color(in.arguments, "eta");
  std::optional<desc::Value> k = in.textures.find_color(in.arguments, "k");
  if (!eta || !k) {
    const ComplexIndex named = index_by_name(in);
    if (!eta) eta = named.eta;
    if (!k) k = named.k;
  }
  in.arguments.accept({"material"});
  node.set("eta", in.textures.scaled(in.where(), *eta, desc::Rgb(1.F / outside)));
  node.set("k", in.textures.scaled(in.where(), *k, desc::Rgb(1.F / outside)));
}

/// A metal that reflects only a share of what it should: a mix with black.
Surface tinted(const MaterialInputs& in, desc::Node metal) {
  const desc::Value tint = in.textures.color(in.arguments, "specular_reflectance", desc::Rgb(1.F));
  const desc::MaterialId id = in.materials.add(in.arguments.element(), std::move(metal));
  if (tint == desc::Value(Vec3(1.F))) return {id, desc::kNone, true};
  const desc::MaterialId black = in.materials.black();
  return {in.materials.add(in.arguments.element(),
                           desc::material_node("mix", {{"amount", tint},
                                                       {"first", desc::MaterialRef{id}},
                                                       {"second", desc::MaterialRef{black}}})),
          desc::kNone, true};
}

bool is_ideal_mirror(const MaterialInputs& in) {
  return in.arguments.text("material", "") == "none";
}

Surface mirror(const MaterialInputs& in) {
  const desc::Value tint = in.textures.color(in.arguments, "specular_reflectance", desc::Rgb(1.F));
  in.arguments.accept({"ext_eta"});
  return {in.materials.add(in.arguments.element(),
                           desc::material_node("mirror", {{"reflectance", tint}})),
          desc::kNone, true};
}

}  // namespace

Surface make_dielectric(const MaterialInputs& in) {
  return {in.materials.add(in.arguments.element(), dielectric(in, false))};
}

Surface make_thin_dielectric(const MaterialInputs& in) {
  return {in.materials.add(in.arguments.element(), dielectric(in, true))};
}

Surface make_rough_dielectric(const MaterialInputs& in) {
  desc::Node node = dielectric(in, false);
  read_ggx_roughness(in).set(node);
  return {in.materials.add(in.arguments.element(), std::move(node))};
}

Surface make_conductor(const MaterialInputs& in) {
  if (is_ideal_mirror(in)) return mirror(in);
  desc::Node node = desc::material_node(
      "conductor", {{"roughness", 0.F}, {"distribution", std::string("smooth")}});
  set_index(in, node);
  return tinted(in, std::move(node));
}

Surface make_rough_conductor(const MaterialInputs& in) {
  desc::Node node = desc::material_node("conductor");
  const Roughness roughness = read_roughness(in);
  roughness.set(node);
  node.set("distribution", roughness.distribution);
  if (is_ideal_mirror(in)) {
    // An extinction that is beyond all others reflects everything at any angle.
    node.set("eta", Vec3(0.F));
    node.set("k", Vec3(1.F));
  } else {
    set_index(in, node);
  }
  return tinted(in, std::move(node));
}

}  // namespace ajar::mitsuba
