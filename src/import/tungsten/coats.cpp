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
constexpr WarningKind kAbsorption{Effect::Slight,
                                  "layers absorb light: as much from all sides stands in"};
constexpr WarningKind kCoat{Effect::Surface, "coats are not supported: blends stand in"};

/// A layer of a dielectric.
struct Layer {
  double ior;
  Vec3 tau;  ///< optical thickness
};

Layer layer_of(const BsdfInputs& in, float usual_ior) {
  const float ior = in.object.number("ior").value_or(usual_ior);
  if (!(ior > 0.F)) throw SceneError(in.where(), "\"ior\" must be positive");
  const Vec3 sigma = in.object.vector("sigma_a").value_or(Vec3(0.F));
  const float thickness = in.object.number("thickness").value_or(1.F);
  if (ior < 1.F)
    in.warn(kThinLayer, "an \"ior\" below 1 is not supported for a layer: 1, no gloss");
  return {static_cast<double>(ior), not_negative(in.context, in.where(), sigma * thickness)};
}

/// What `function` of a number is of each lane.
template <typename Function>
Vec3 per_lane(const Vec3& lanes, Function function) {
  return {static_cast<float>(function(static_cast<double>(lanes.x))),
          static_cast<float>(function(static_cast<double>(lanes.y))),
          static_cast<float>(function(static_cast<double>(lanes.z)))};
}

/// Share of light that goes through the layer to a white diffuse base and out again, without what
/// the layer turns back.
double passed_once(const Layer& layer) {
  return (1.0 - mean_reflectance(layer.ior)) * (1.0 - mean_internal_reflectance(layer.ior));
}

/// Share of light that a plastic's layer leaves on the way in and out, on average over all
/// directions: Tungsten measures the way by those outside of the layer.
Vec3 left_by(const Layer& layer) {
  return per_lane(layer.tau, [&](double tau) {
    const double once = mean_transmittance(1.0, tau);
    return once * once;
  });
}

void warn_of_absorption(const BsdfInputs& in, const Layer& layer) {
  if (layer.tau != Vec3(0.F)) {
    in.warn(kAbsorption, "a layer absorbs as much light from all sides here");
  }
}

desc::Node coated_diffuse(const Layer& layer, const desc::Value& albedo,
                          const desc::Value& roughness) {
  return desc::material_node("coated_diffuse", {{"coat", std::string("dielectric")},
                                                {"eta", static_cast<float>(layer.ior)},
                                                {"diffuse_reflectance", albedo},
                                                {"roughness", roughness}});
}

desc::Node plastic_of(const BsdfInputs& in, const desc::Value& roughness) {
  const Layer layer = layer_of(in, 1.5F);
  warn_of_absorption(in, layer);
  const Vec3 left = left_by(layer);
  const desc::Value albedo = in.albedo();
  // Only what leaves is weakened there, not what goes to and fro.
  const double back = mean_internal_reflectance(layer.ior);
  const auto weakened = [&](const Vec3& color) {
    Vec3 result;
    for (int lane = 0; lane < 3; ++lane) {
      const double base = std::clamp(static_cast<double>(color[lane]), 0.0, 1.0);
      const double leaves = static_cast<double>(left[lane]) * base / (1.0 - base * back);
      result[lane] = static_cast<float>(leaves / (1.0 + leaves * back));
    }
    return result;
  };
  const Vec3* constant = std::get_if<Vec3>(&albedo);
  // A texture can only be scaled: rightly for what is half as bright as white.
  const desc::Value base = constant != nullptr
                               ? desc::Value(weakened(*constant))
                               : in.textures.product(albedo, weakened(Vec3(0.5F)) * 2.F);
  return coated_diffuse(layer, base, roughness);
}

desc::Node metal_below(const BsdfInputs& in, const Layer& layer, const desc::Node& metal,
                       const desc::Value& roughness) {
  desc::Node node =
      coated_metal(metal, static_cast<float>(layer.ior), in.where(), in.context.warnings);
  node.set("coat_depth", layer.tau);
  node.set("coat_roughness", roughness);
  return node;
}

/// A blend whose first part, the coat, reflects more than the layer does by as much as the blend
/// weakens it, since only blends of two materials exist and no sums.
desc::Node blended_coat(const BsdfInputs& in, const Layer& layer, desc::MaterialId base,
                        const desc::Value& roughness) {
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
  const bool is_smooth = roughness == desc::Value(0.F);
  if (!is_smooth) coat.set("roughness", roughness);
  coat.set(is_smooth ? "mirror_reflectance" : "glossy_reflectance",
           per_lane(coat_share, [&](double share) {
             return std::min(static_cast<double>(least) / std::max(share, 1e-6), 1.0);
           }));
  const desc::MaterialId coat_id = in.add(std::move(coat));
  return desc::material_node("mix", {{"amount", coat_share},
                                     {"first", desc::MaterialRef{coat_id}},
                                     {"second", desc::MaterialRef{base}}});
}

desc::Node coated(const BsdfInputs& in, const desc::Value& roughness) {
  in.object.accept({"albedo", "color"});
  const Layer layer = layer_of(in, 1.3F);
  const std::optional<desc::MaterialId> given = in.part("substrate");
  const desc::MaterialId base =
      given
          ? *given
          : in.add(desc::material_node(
                "conductor",
                {{"eta", find_metal("Cu")->eta}, {"k", find_metal("Cu")->k}, {"roughness", 0.1F}}));
  const desc::Node below = in.context.scene.materials[static_cast<std::size_t>(base)].node;
  if (below.is("diffuse") && below.get("sigma") == desc::Value(0.F)) {
    desc::Node node = coated_diffuse(layer, below.get("reflectance"), roughness);
    node.set("coat_depth", layer.tau);
    node.set("bounces", 1);
    return node;
  }
  if (below.is("conductor")) return metal_below(in, layer, below, roughness);
  return blended_coat(in, layer, base, roughness);
}

}  // namespace

desc::Node plastic(const BsdfInputs& in) { return plastic_of(in, 0.F); }

desc::Node rough_plastic(const BsdfInputs& in) {
  expect_ggx(in);
  return plastic_of(in, in.number("roughness", 0.02F));
}

desc::Node smooth_coat(const BsdfInputs& in) { return coated(in, 0.F); }

desc::Node rough_coat(const BsdfInputs& in) {
  expect_ggx(in);
  return coated(in, in.number("roughness", 0.02F));
}

}  // namespace ajar::tungsten
