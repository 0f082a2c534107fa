#include <cmath>

#include "import/common/coated_metal.h"
#include "import/mitsuba/node_maker.h"
#include "import/mitsuba/refraction.h"
#include "import/mitsuba/roughness.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kCoat{Effect::Surface, "materials have a coat, which is left out"};
constexpr WarningKind kTintedCoat{Effect::Surface,
                                  "coats of metals have a tint, which is left out"};
constexpr WarningKind kThinCoat{Effect::Surface,
                                "coats are thinner than what is outside: no gloss"};
constexpr WarningKind kTiltedCoat{Effect::Slight,
                                  "bump or normal maps below a coat tilt the coat, too"};
constexpr WarningKind kSmoothBelow{Effect::Slight,
                                   "rough diffuse bases below coats are shown as smooth ones"};
constexpr WarningKind kOldGloss{
    Effect::Surface, "materials are phong or ward, which are not supported: coated ones stand in"};
constexpr WarningKind kExponent{Effect::Surface,
                                "exponents of phong vary, which is not supported: 30 stands in"};

bool is_constant(const desc::Node& node, const char* name) {
  return std::holds_alternative<Vec3>(node.get(name));
}

/// Index of a coat. The base has no gloss if the coat is the thinner medium.
float index_of_coat(const MaterialInputs& in, std::string_view usual) {
  const float eta = relative_index(in.arguments, usual);
  if (eta < 1.F) {
    in.context().warnings.add(
        kThinCoat, in.where(),
        "a coat that is thinner than what is outside is not supported: it has "
        "no gloss");
  }
  return eta;
}

/// Transmission of the facets of a rough coat: a table of light that meets one of them, in all
/// versions. The rest is reflected back inside in 0.x; since 2 it is lost there, too.
std::string transmission_of_rough_coat(const MaterialInputs& in) {
  return in.context().document.major_version == 0 ? "single" : "lossy_sum";
}

/// Diffuse under a coat.
desc::Node coated_diffuse(const MaterialInputs& in, float eta, const desc::Value& base,
                          bool is_rough) {
  desc::Node node = desc::material_node(
      "coated_diffuse", {{"coat", std::string("dielectric")},
                         {"eta", eta},
                         {"diffuse_reflectance", base},
                         {"coat_reflectance",
                          in.textures.color(in.arguments, "specular_reflectance", desc::Rgb(1.F))},
                         {"roughness", 0.F}});
  if (is_rough) {
    read_roughness(in).set(node);
    node.set("coat_transmission", transmission_of_rough_coat(in));
  }
  return node;
}

/// Unless "nonlinear", Mitsuba takes the base for white where light goes to and fro below the
/// boundary, so that its colour does not change.
Surface plastic(const MaterialInputs& in, bool is_rough) {
  const float eta = index_of_coat(in, "polypropylene");
  const desc::Value base = in.textures.color(in.arguments, "diffuse_reflectance", desc::Rgb(0.5F));
  desc::Node node = coated_diffuse(in, eta, base, is_rough);
  if (!in.arguments.flag("nonlinear", false)) node.set("inner_reflections", std::string("white"));
  return {in.materials.add(in.arguments.element(), std::move(node)), desc::kNone, true};
}

desc::Node metal_below(const MaterialInputs& in, const MetalCoat& coat, const desc::Node& metal) {
  if (in.textures.color(in.arguments, "specular_reflectance", desc::Rgb(1.F)) !=
      desc::Value(Vec3(1.F))) {
    in.context().warnings.add(kTintedCoat, in.where(),
                              "\"specular_reflectance\" of a coat on metal is not supported: 1");
  }
  desc::Node node = coated_metal(metal, coat, in.where(), in.context().warnings);
  if (coat.is_rough) {
    const Roughness facets = read_roughness(in);
    node.set("coat_roughness", facets.alpha);
    if (facets.alpha_v) node.set("coat_roughness_v", *facets.alpha_v);
    node.set("coat_distribution", facets.distribution);
    node.set("coat_transmission", std::string("single"));
  }
  return node;
}

Surface coating(const MaterialInputs& in, bool is_rough) {
  const Element* nested = in.arguments.only_child("bsdf");
  if (nested == nullptr) throw SceneError(in.where(), "a coating needs a bsdf in it");
  const Surface inner = in.materials.make(*nested);
  const desc::Material base = in.materials.get(inner.material);
  const desc::Rgb depth = in.arguments.color("sigma_a").value_or(desc::Rgb(0.F)) *
                          in.arguments.number("thickness", 1.F);
  const float eta = index_of_coat(in, "bk7");
  if (base.has_relief()) {
    in.context().warnings.add(kTiltedCoat, in.where(),
                              "the bump or normal map below this coat tilts the coat, too");
  }
  const auto finished = [&](desc::Node node) {
    const desc::MaterialId id = in.materials.add(in.arguments.element(), std::move(node));
    in.context().scene.materials.back().bump = base.bump;
    in.context().scene.materials.back().normal_map = base.normal_map;
    return Surface{id, inner.alpha, inner.is_one_sided};
  };
  if (base.node.is("diffuse")) {
    if (base.node.get("sigma") != desc::Value(0.F)) {
      in.context().warnings.add(kSmoothBelow, in.where(),
                                "a rough diffuse base below a coat is shown as a smooth one");
    }
    desc::Node node = coated_diffuse(in, eta, base.node.get("reflectance"), is_rough);
    node.set("coat_depth", Vec3(depth));
    node.set("bounces", 1);
    if (is_rough) node.set("coat_transmission", std::string("single"));
    return finished(std::move(node));
  }
  if (base.node.is("conductor") && is_constant(base.node, "eta") && is_constant(base.node, "k")) {
    return finished(metal_below(in, {eta, Vec3(depth), is_rough}, base.node));
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
Surface make_polarized_plastic(const MaterialInputs& in) {
  const desc::Value base = in.textures.color(in.arguments, "diffuse_reflectance", desc::Rgb(0.5F));
  desc::Node node = coated_diffuse(in, index_of_coat(in, "polypropylene"), base, true);
  node.set("coat_transmission", std::string("smooth"));
  node.set("inner_reflections", std::string("windows"));
  return {in.materials.add(in.arguments.element(), std::move(node)), desc::kNone, true};
}
Surface make_coating(const MaterialInputs& in) { return coating(in, false); }
Surface make_rough_coating(const MaterialInputs& in) { return coating(in, true); }

Surface make_phong(const MaterialInputs& in) {
  constexpr float kUsualExponent = 30.F;
  desc::Node node = glossy(in);
  if (in.arguments.texture("exponent") != nullptr) {
    in.context().warnings.add(kExponent, in.where(),
                              "an \"exponent\" that varies is not supported: 30 stands in");
  }
  // Walter et al. 2007, section 5.1: facets that make a highlight of about that exponent.
  const float exponent = in.arguments.number("exponent", kUsualExponent);
  node.set("roughness", std::sqrt(2.F / (std::max(exponent, 0.F) + 2.F)));
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
