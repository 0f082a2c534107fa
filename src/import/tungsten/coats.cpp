#include "import/tungsten/coats.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "import/tungsten/coat_optics.h"
#include "import/tungsten/metals.h"
#include "scene/desc/models.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kPlastic{Effect::Slight,
                               "plastics are not supported: a diffuse base with a gloss stands in"};
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
  return {static_cast<double>(ior), not_negative(in.context, in.where(), sigma * thickness)};
}

/// What `function` of a number is of each lane.
template <typename Function>
Vec3 per_lane(const Vec3& lanes, Function function) {
  return {static_cast<float>(function(static_cast<double>(lanes.x))),
          static_cast<float>(function(static_cast<double>(lanes.y))),
          static_cast<float>(function(static_cast<double>(lanes.z)))};
}

/// Share of the light that a diffuse base of this albedo sends back through the layer. What the
/// layer reflects back to the base comes again, which makes a dark base darker still.
double returned_share(const Layer& layer, double albedo) {
  const double back = mean_internal_reflectance(layer.ior);
  return (1.0 - mean_reflectance(layer.ior)) * (1.0 - back) / (1.0 - albedo * back);
}

/// `gloss` is what the layer itself reflects, "glossy_reflectance" or "mirror_reflectance".
desc::Node base_under_gloss(const BsdfInputs& in, std::string_view gloss,
                            const desc::Value& roughness) {
  in.warn(kPlastic,
          "plastic is not supported: a diffuse base with a gloss, of the same share of "
          "reflected light, stands in");
  const Layer layer = layer_of(in, 1.5F);
  const desc::Value albedo = in.albedo();
  // A texture can only be scaled: rightly for what is half as bright as white.
  const Vec3 shares = per_lane(constant_or(albedo, Vec3(0.5F)), [&](double lane) {
    return returned_share(layer, std::clamp(lane, 0.0, 1.0));
  });
  // Tungsten measures the way through the layer by the directions outside of it.
  const Vec3 left = per_lane(layer.tau, [](double tau) {
    const double once = mean_transmittance(1.0, tau);
    return once * once;
  });
  desc::Node node = desc::material_node(
      "composite", {{"diffuse_reflectance", in.textures.product(albedo, shares * left)},
                    {"glossy_reflectance", Vec3(0.F)},
                    {"eta", static_cast<float>(layer.ior)},
                    {"roughness", roughness}});
  node.set(gloss, Vec3(1.F));
  return node;
}

/// A blend whose first part, the coat, reflects more than the layer does by as much as the blend
/// weakens it, since only blends of two materials exist and no sums.
desc::Node coated(const BsdfInputs& in, std::string_view gloss, const desc::Value& roughness) {
  in.warn(kCoat,
          "coats are not supported: a blend of a gloss and of what is under it, of the same "
          "share of reflected light, stands in");
  in.object.accept({"albedo", "color"});
  const Layer layer = layer_of(in, 1.3F);
  const std::optional<desc::MaterialId> given = in.part("substrate");
  const desc::MaterialId base =
      given
          ? *given
          : in.add(desc::material_node(
                "conductor",
                {{"eta", find_metal("Cu")->eta}, {"k", find_metal("Cu")->k}, {"roughness", 0.1F}}));
  const bool is_diffuse =
      in.context.scene.materials[static_cast<std::size_t>(base)].node.is("diffuse");
  const Vec3 coat_share = per_lane(layer.tau, [&](double tau) {
    const double once = mean_transmittance(layer.ior, tau);
    const double through =
        is_diffuse ? returned_share(layer, 0.0) * once * once : mean_round_trip(layer.ior, tau);
    return 1.0 - through;
  });
  const float least = std::min({coat_share.x, coat_share.y, coat_share.z});
  constexpr double kMostReflective = 0.9;
  const double reflected = std::min(
      mean_reflectance(layer.ior) / std::max(static_cast<double>(least), 1e-6), kMostReflective);
  desc::Node coat = desc::material_node(
      "composite", {{"diffuse_reflectance", Vec3(0.F)},
                    {"glossy_reflectance", Vec3(0.F)},
                    {"eta", static_cast<float>(ior_of_mean_reflectance(reflected))},
                    {"roughness", roughness}});
  coat.set(gloss, per_lane(coat_share, [&](double share) {
             return std::min(static_cast<double>(least) / std::max(share, 1e-6), 1.0);
           }));
  const desc::MaterialId coat_id = in.add(std::move(coat));
  return desc::material_node("mix", {{"amount", coat_share},
                                     {"first", desc::MaterialRef{coat_id}},
                                     {"second", desc::MaterialRef{base}}});
}

}  // namespace

desc::Node plastic(const BsdfInputs& in) {
  return base_under_gloss(in, "mirror_reflectance", 0.1F);
}

desc::Node rough_plastic(const BsdfInputs& in) {
  expect_ggx(in);
  return base_under_gloss(in, "glossy_reflectance", in.number("roughness", 0.02F));
}

desc::Node smooth_coat(const BsdfInputs& in) { return coated(in, "mirror_reflectance", 0.1F); }

desc::Node rough_coat(const BsdfInputs& in) {
  expect_ggx(in);
  return coated(in, "glossy_reflectance", in.number("roughness", 0.02F));
}

}  // namespace ajar::tungsten
