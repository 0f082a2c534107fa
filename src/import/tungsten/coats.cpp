#include "import/tungsten/coats.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "import/common/coated_metal.h"
#include "import/tungsten/coat_optics.h"
#include "import/tungsten/metals.h"
#include "scene/desc/models.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kThinLayer{Effect::Surface,
                                 "layers have an index of refraction below 1: no gloss"};
constexpr WarningKind kCoat{Effect::Surface, "coats are not supported: blends stand in"};

/// A layer of a dielectric.
struct Layer {
  double ior;
  Vec3 tau;  ///< optical thickness
};

/// Properties of the surface of a layer.
struct Facets {
  desc::Value roughness = 0.F;
  std::string distribution = "ggx";
};
Facets rough_facets(const BsdfInputs& in) {
  return {in.number("roughness", 0.02F), distribution_of(in)};
}

Layer layer_of(const BsdfInputs& in, float usual_ior) {
  const float ior = in.object.number("ior").value_or(usual_ior);
  if (!(ior > 0.F)) throw SceneError(in.where(), "\"ior\" must be positive");
  const Vec3 sigma = in.object.vector("sigma_a").value_or(Vec3(0.F));
  const float thickness = in.object.number("thickness").value_or(1.F);
  if (ior < 1.F)
    in.warn(kThinLayer, "an \"ior\" below 1 is not supported for a layer: 1, no gloss");
  return {static_cast<double>(ior), not_negative(in.context, in.where(), sigma * thickness)};
}

/// Applies `function` of a number to each lane.
template <typename Function>
Vec3 per_lane(const Vec3& lanes, Function function) {
  return {static_cast<float>(function(static_cast<double>(lanes.x))),
          static_cast<float>(function(static_cast<double>(lanes.y))),
          static_cast<float>(function(static_cast<double>(lanes.z)))};
}

/// Share of light that goes through the layer to a white diffuse base and out again, without
/// internal reflection.
double passed_once(const Layer& layer) {
  return (1.0 - mean_reflectance(layer.ior)) * (1.0 - mean_internal_reflectance(layer.ior));
}

/// Diffuse below a layer. A rough layer lets as much through as a smooth one there.
desc::Node coated_diffuse(const Layer& layer, const desc::Value& albedo, const Facets& facets) {
  return desc::material_node("coated_diffuse", {{"coat", std::string("dielectric")},
                                                {"eta", static_cast<float>(layer.ior)},
                                                {"diffuse_reflectance", albedo},
                                                {"coat_depth", layer.tau},
                                                {"coat_transmission", std::string("smooth")},
                                                {"roughness", facets.roughness},
                                                {"distribution", facets.distribution},
                                                {"masking", kMasking}});
}

desc::Node plastic_of(const BsdfInputs& in, const Facets& facets) {
  desc::Node node = coated_diffuse(layer_of(in, 1.5F), in.albedo(), facets);
  node.set("coat_ways", std::string("straight"));
  return node;
}

desc::Node metal_below(const BsdfInputs& in, const Layer& layer, const desc::Node& metal,
                       const Facets& facets) {
  const MetalCoat coat{static_cast<float>(layer.ior), layer.tau,
                       facets.roughness != desc::Value(0.F)};
  desc::Node node = coated_metal(metal, coat, in.where(), in.context.warnings);
  node.set("coat_roughness", facets.roughness);
  node.set("coat_distribution", facets.distribution);
  node.set("coat_transmission", std::string("smooth"));
  return node;
}

/// A blend whose first part, the coat, reflects more than the layer does by as much as the blend
/// weakens it, since only blends of two materials exist and no sums.
desc::Node blended_coat(const BsdfInputs& in, const Layer& layer, desc::MaterialId base,
                        const Facets& facets) {
  in.warn(kCoat,
          "a coat of this is not supported: a blend of a gloss and of what is under it, of the "
          "same share of reflected light, stands in");
  const bool is_diffuse =
      in.context.scene.materials[static_cast<std::size_t>(base)].node.is("diffuse");
  const Vec3 coat_share = per_lane(layer.tau, [&](double tau) {
    const double once = mean_transmittance(layer.ior, tau);
    const double through =
        is_diffuse ? passed_once(layer) * once * once : mean_round_trip(layer.ior, tau);
    return 1.0 - through;
  });
  const float least = std::min({coat_share.x, coat_share.y, coat_share.z});
  constexpr double kMostReflective = 0.9;
  const double reflected = std::min(
      mean_reflectance(layer.ior) / std::max(static_cast<double>(least), 1e-6), kMostReflective);
  desc::Node coat = desc::material_node(
      "composite", {{"diffuse_reflectance", Vec3(0.F)},
                    {"glossy_reflectance", Vec3(0.F)},
                    {"eta", static_cast<float>(ior_of_mean_reflectance(reflected))}});
  const bool is_smooth = facets.roughness == desc::Value(0.F);
  if (!is_smooth) coat.set("roughness", facets.roughness);
  coat.set(is_smooth ? "mirror_reflectance" : "glossy_reflectance",
           per_lane(coat_share, [&](double share) {
             return std::min(static_cast<double>(least) / std::max(share, 1e-6), 1.0);
           }));
  const desc::MaterialId coat_id = in.add(std::move(coat));
  return desc::material_node("mix", {{"amount", coat_share},
                                     {"first", desc::MaterialRef{coat_id}},
                                     {"second", desc::MaterialRef{base}}});
}

desc::Node coated(const BsdfInputs& in, const Facets& facets) {
  in.object.accept({"albedo", "color"});
  const Layer layer = layer_of(in, 1.3F);
  const std::optional<desc::MaterialId> given = in.part("substrate");
  const desc::MaterialId base =
      given ? *given
            : in.add(desc::material_node("conductor", {{"eta", find_metal("Cu")->eta},
                                                       {"k", find_metal("Cu")->k},
                                                       {"roughness", 0.1F},
                                                       {"masking", kMasking}}));
  const desc::Node below = in.context.scene.materials[static_cast<std::size_t>(base)].node;
  if (below.is("diffuse") && below.get("sigma") == desc::Value(0.F)) {
    desc::Node node = coated_diffuse(layer, below.get("reflectance"), facets);
    node.set("bounces", 1);
    return node;
  }
  if (below.is("conductor")) return metal_below(in, layer, below, facets);
  return blended_coat(in, layer, base, facets);
}

}  // namespace

desc::Node plastic(const BsdfInputs& in) { return plastic_of(in, {}); }
desc::Node rough_plastic(const BsdfInputs& in) { return plastic_of(in, rough_facets(in)); }
desc::Node smooth_coat(const BsdfInputs& in) { return coated(in, {}); }
desc::Node rough_coat(const BsdfInputs& in) { return coated(in, rough_facets(in)); }

}  // namespace ajar::tungsten
