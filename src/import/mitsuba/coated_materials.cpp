#include <cmath>

#include "import/mitsuba/node_maker.h"
#include "import/mitsuba/refraction.h"
#include "import/mitsuba/roughness.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kPlastic{
    Effect::Slight,
    "plastics have a base that light enters and leaves by the laws of refraction: a "
    "diffuse one of the same mean brightness stands in"};
constexpr WarningKind kCoat{Effect::Surface, "materials have a coat, which is left out"};
constexpr WarningKind kClearCoat{Effect::Surface,
                                 "coats absorb light in Mitsuba: clear ones stand in"};
constexpr WarningKind kOldGloss{
    Effect::Surface, "materials are phong or ward, which are not supported: coated ones stand in"};

/// Share of light that a diffuse base of reflectance `base` under a smooth boundary returns to all
/// sides. `again`: the share of what the boundary reflects back that is counted.
float returned_share(float eta, float again) {
  const float enters = 1.F - diffuse_fresnel_reflectance(eta);
  const float turned_back = diffuse_fresnel_reflectance(1.F / eta);
  return enters * (1.F - turned_back) / (1.F - again * turned_back);
}

/// Of a plastic's base. Unless "nonlinear", Mitsuba takes the base for white where light goes to
/// and fro below the boundary, so that its colour does not change.
desc::Value base_of_plastic(const MaterialInputs& in, float eta) {
  const desc::Value base = in.textures.color(in.arguments, "diffuse_reflectance", desc::Rgb(0.5F));
  const bool nonlinear = in.arguments.flag("nonlinear", false);
  if (!nonlinear) return in.textures.scaled(in.where(), base, desc::Rgb(returned_share(eta, 1.F)));
  // Of a texture, as if it were of medium brightness.
  const Vec3* color = std::get_if<Vec3>(&base);
  const Vec3 again = color == nullptr ? Vec3(0.5F) : *color;
  const desc::Rgb share(returned_share(eta, again.x), returned_share(eta, again.y),
                        returned_share(eta, again.z));
  return in.textures.scaled(in.where(), base, share);
}

/// Diffuse under a boundary. `gloss` is the parameter that the boundary is tinted by.
desc::Node coated(const MaterialInputs& in, float eta, const desc::Value& base, const char* gloss) {
  desc::Node node = desc::material_node(
      "composite", {{"diffuse_reflectance", base}, {"glossy_reflectance", Vec3(0.F)}});
  node.set("eta", eta);
  node.set(gloss, in.textures.color(in.arguments, "specular_reflectance", desc::Rgb(1.F)));
  return node;
}

Surface plastic(const MaterialInputs& in, bool is_rough) {
  in.context().warnings.add(kPlastic, in.where(),
                            "the base of plastic is diffuse in itself here, of the same mean "
                            "brightness");
  const float eta = relative_index(in.arguments, "polypropylene");
  desc::Node node = coated(in, eta, base_of_plastic(in, eta),
                           is_rough ? "glossy_reflectance" : "mirror_reflectance");
  if (is_rough) read_ggx_roughness(in).set(node);
  return {in.materials.add(in.arguments.element(), std::move(node)), desc::kNone, true};
}

Surface coating(const MaterialInputs& in, bool is_rough) {
  const std::vector<const Element*> nested = in.arguments.children("bsdf");
  if (nested.empty()) throw SceneError(in.where(), "a coating needs a bsdf in it");
  const Surface inner = in.materials.make(*nested.front());
  const desc::Material base = in.materials.get(inner.material);
  if (in.arguments.color("sigma_a").value_or(desc::Rgb(0.F)) != desc::Rgb(0.F)) {
    in.context().warnings.add(kClearCoat, in.where(),
                              "\"sigma_a\" of a coat is not supported: it is clear");
  }
  in.arguments.accept({"thickness"});
  if (!base.node.is("diffuse")) {
    in.context().warnings.add(kCoat, in.where(),
                              "a coat is only supported on diffuse materials: left out");
    in.arguments.accept_all();
    return inner;
  }
  in.context().warnings.add(kPlastic, in.where(),
                            "the base below a coat is diffuse in itself here, of the same mean "
                            "brightness");
  const float eta = relative_index(in.arguments, "bk7");
  const desc::Value color = in.textures.scaled(in.where(), base.node.get("reflectance"),
                                               desc::Rgb(returned_share(eta, 0.F)));
  desc::Node node = coated(in, eta, color, is_rough ? "glossy_reflectance" : "mirror_reflectance");
  if (is_rough) read_ggx_roughness(in).set(node);
  const desc::MaterialId id = in.materials.add(in.arguments.element(), std::move(node));
  return {id, inner.alpha, inner.is_one_sided};
}

/// A gloss over a diffuse base, both given by their colours alone.
desc::Node glossy(const MaterialInputs& in) {
  in.context().warnings.add(
      kOldGloss, in.where(),
      "bsdf \"" + in.arguments.element().type +
          "\" is not supported: a diffuse one with a coat of like roughness stands in",
      in.arguments.element().type);
  return make_node(in.context(), in.where(), desc::ModelKind::Material, "coated_diffuse",
                   {{"diffuse_reflectance",
                     in.textures.color(in.arguments, "diffuse_reflectance", desc::Rgb(0.5F))},
                    {"glossy_reflectance",
                     in.textures.color(in.arguments, "specular_reflectance", desc::Rgb(0.2F))}});
}

}  // namespace

Surface make_plastic(const MaterialInputs& in) { return plastic(in, false); }
Surface make_rough_plastic(const MaterialInputs& in) { return plastic(in, true); }
Surface make_coating(const MaterialInputs& in) { return coating(in, false); }
Surface make_rough_coating(const MaterialInputs& in) { return coating(in, true); }

Surface make_phong(const MaterialInputs& in) {
  desc::Node node = glossy(in);
  // Walter et al. 2007, section 5.1: facets that make a highlight of about that exponent.
  const desc::Value exponent = in.textures.number(in.arguments, "exponent", 30.F);
  const float* number = std::get_if<float>(&exponent);
  node.set("roughness", std::sqrt(2.F / (std::max(number == nullptr ? 30.F : *number, 0.F) + 2.F)));
  return {in.materials.add(in.arguments.element(), std::move(node)), desc::kNone, true};
}

Surface make_ward(const MaterialInputs& in) {
  desc::Node node = glossy(in);
  node.set("roughness", in.textures.number(in.arguments, "alpha_u", 0.1F));
  node.set("roughness_v", in.textures.number(in.arguments, "alpha_v", 0.1F));
  in.arguments.accept({"variant"});
  return {in.materials.add(in.arguments.element(), std::move(node)), desc::kNone, true};
}

}  // namespace ajar::mitsuba
