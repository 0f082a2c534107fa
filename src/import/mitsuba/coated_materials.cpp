#include <cmath>

#include "import/common/coated_metal.h"
#include "import/mitsuba/node_maker.h"
#include "import/mitsuba/refraction.h"
#include "import/mitsuba/roughness.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kCoat{Effect::Surface, "materials have a coat, which is left out"};
constexpr WarningKind kClearCoat{Effect::Surface,
                                 "coats absorb light in Mitsuba: clear ones stand in"};
constexpr WarningKind kCoatedMetal{
    Effect::Slight, "metals have a coat: light that goes to and fro between the two is shown"};
constexpr WarningKind kTintedCoat{Effect::Surface,
                                  "coats of metals have a tint, which is left out"};
constexpr WarningKind kBeckmannBelow{
    Effect::Slight, "metals below a coat have facets of a distribution that is not supported"};
constexpr WarningKind kOldGloss{
    Effect::Surface, "materials are phong or ward, which are not supported: coated ones stand in"};

bool is_constant(const desc::Node& node, const char* name) {
  return std::holds_alternative<Vec3>(node.get(name));
}

/// Diffuse under a coat. Mitsuba knows three: `inner_reflections` of our model.
desc::Node coated_diffuse(const MaterialInputs& in, float eta, const desc::Value& base,
                          const std::string& inner_reflections, bool is_rough) {
  desc::Node node = desc::material_node(
      "coated_diffuse", {{"coat", std::string("dielectric")},
                         {"eta", eta},
                         {"diffuse_reflectance", base},
                         {"coat_reflectance",
                          in.textures.color(in.arguments, "specular_reflectance", desc::Rgb(1.F))},
                         {"inner_reflections", inner_reflections},
                         {"roughness", 0.F}});
  if (is_rough) read_ggx_roughness(in).set(node);
  return node;
}

/// Unless "nonlinear", Mitsuba takes the base for white where light goes to and fro below the
/// boundary, so that its colour does not change.
Surface plastic(const MaterialInputs& in, bool is_rough) {
  const float eta = relative_index(in.arguments, "polypropylene");
  const desc::Value base = in.textures.color(in.arguments, "diffuse_reflectance", desc::Rgb(0.5F));
  const std::string inner = in.arguments.flag("nonlinear", false) ? "base" : "white";
  desc::Node node = coated_diffuse(in, eta, base, inner, is_rough);
  return {in.materials.add(in.arguments.element(), std::move(node)), desc::kNone, true};
}

desc::Node metal_below(const MaterialInputs& in, float eta, const desc::Node& metal,
                       bool is_rough) {
  in.context().warnings.add(kCoatedMetal, in.where(),
                            "what goes to and fro between a metal and its coat is shown here");
  if (in.textures.color(in.arguments, "specular_reflectance", desc::Rgb(1.F)) !=
      desc::Value(Vec3(1.F))) {
    in.context().warnings.add(kTintedCoat, in.where(),
                              "\"specular_reflectance\" of a coat on metal is not supported: 1");
  }
  if (metal.text("distribution") == "beckmann") {
    in.context().warnings.add(kBeckmannBelow, in.where(),
                              "the facets of a metal below a coat are those of \"ggx\" here");
  }
  desc::Node node = coated_metal(metal, eta);
  if (is_rough) {
    const Roughness coat = read_ggx_roughness(in);
    node.set("coat_roughness", coat.alpha);
    if (coat.alpha_v) node.set("coat_roughness_v", *coat.alpha_v);
  }
  return node;
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
  const float eta = relative_index(in.arguments, "bk7");
  const auto finished = [&](desc::Node node) {
    const desc::MaterialId id = in.materials.add(in.arguments.element(), std::move(node));
    in.context().scene.materials.back().bump = base.bump;
    in.context().scene.materials.back().normal_map = base.normal_map;
    return Surface{id, inner.alpha, inner.is_one_sided};
  };
  if (base.node.is("diffuse") && base.node.get("sigma") == desc::Value(0.F)) {
    return finished(coated_diffuse(in, eta, base.node.get("reflectance"), "none", is_rough));
  }
  if (base.node.is("conductor") && is_constant(base.node, "eta") && is_constant(base.node, "k")) {
    return finished(metal_below(in, eta, base.node, is_rough));
  }
  in.context().warnings.add(kCoat, in.where(),
                            "a coat is only supported on diffuse materials and metals: left out");
  in.arguments.accept_all();
  return inner;
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
