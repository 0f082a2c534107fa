#include "core/printable_text.h"
#include "import/common/conductors.h"
#include "import/mitsuba/names.h"
#include "import/mitsuba/refraction.h"
#include "import/mitsuba/roughness.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnknownConductor{Effect::Surface,
                                        "conductors have unknown names: copper stands in"};

constexpr WarningKind kGgxConductor{
    Effect::Slight, "metals have the Fresnel term of Schlick, which is not supported: the nearest"};

desc::Node dielectric(const MaterialInputs& in, bool thin) {
  desc::Node node = desc::material_node(
      "dielectric", {{"thin", thin}, {"uncounted", thin && !in.context().counts_straight}});
  node.set("eta", relative_index(in.arguments, "bk7"));
  node.set("reflectance", in.textures.color(in.arguments, "specular_reflectance", desc::Rgb(1.F)));
  node.set("transmittance",
           in.textures.color(in.arguments, "specular_transmittance", desc::Rgb(1.F)));
  return node;
}

/// Index of refraction that a scene gives for a metal, relative to vacuum.
struct GivenIndex {
  std::string material;
  std::optional<desc::Value> eta, k;

  /// An extinction that is beyond all others: everything is reflected at any angle.
  bool is_none() const { return lower_case(material) == "none"; }
  bool is_of_ideal_mirror() const { return is_none() && !eta && !k; }
};
GivenIndex given_index(const MaterialInputs& in) {
  const char* const usual = in.context().document.major_version == 0 ? "Cu" : "none";
  return {in.arguments.text("material", usual), in.textures.find_color(in.arguments, "eta"),
          in.textures.find_color(in.arguments, "k")};
}

ComplexIndex index_by_name(const MaterialInputs& in, const std::string& name) {
  if (const std::optional<ComplexIndex> index = conductor_named(name)) return *index;
  in.context().warnings.add(
      kUnknownConductor, in.where(),
      unknown_name_message("conductor", printable(name), conductor_names()) + ". Copper stands in",
      printable(name));
  return *conductor_named("Cu");
}

/// Sets "eta" and "k", both relative to the outside.
void set_index(const MaterialInputs& in, GivenIndex given, desc::Node& node) {
  const float outside = index_of_refraction(in.arguments, "ext_eta", "air");
  if (!given.eta || !given.k) {
    const ComplexIndex named =
        given.is_none() ? ComplexIndex{Vec3(0.F), Vec3(1.F)} : index_by_name(in, given.material);
    if (!given.eta) given.eta = named.eta;
    if (!given.k) given.k = named.k;
  }
  node.set("eta", in.textures.scaled(in.where(), *given.eta, desc::Rgb(1.F / outside)));
  node.set("k", in.textures.scaled(in.where(), *given.k, desc::Rgb(1.F / outside)));
}

/// A metal that reflects only a share of its reflectance: a mix with black.
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
  read_roughness(in).set(node);
  return {in.materials.add(in.arguments.element(), std::move(node))};
}

Surface make_conductor(const MaterialInputs& in) {
  GivenIndex index = given_index(in);
  if (index.is_of_ideal_mirror()) return mirror(in);
  desc::Node node = desc::material_node(
      "conductor", {{"roughness", 0.F}, {"distribution", std::string("smooth")}});
  set_index(in, std::move(index), node);
  return tinted(in, std::move(node));
}

Surface make_rough_conductor(const MaterialInputs& in) {
  desc::Node node = desc::material_node("conductor");
  read_roughness(in).set(node);
  set_index(in, given_index(in), node);
  return tinted(in, std::move(node));
}

Surface make_ggx_conductor(const MaterialInputs& in) {
  desc::Node node = desc::material_node("conductor");
  Roughness roughness = read_roughness(in);
  roughness.distribution = "ggx";
  roughness.set(node);
  const std::optional<desc::Value> reflectance = in.textures.find_color(in.arguments, "r0");
  if (!reflectance) {
    set_index(in, given_index(in), node);
    return tinted(in, std::move(node));
  }
  in.context().warnings.add(kGgxConductor, in.where(),
                            "the term of Schlick for \"R0\" is not supported: a metal of that "
                            "reflectance stands in, which differs at grazing angles");
  node.set("reflectance", *reflectance);
  return tinted(in, std::move(node));
}

}  // namespace ajar::mitsuba
