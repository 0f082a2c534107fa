#include "import/tungsten/bsdf_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "import/common/opacity.h"
#include "import/tungsten/coats.h"
#include "import/tungsten/metals.h"
#include "scene/desc/models.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kDistribution{
    Effect::Slight, "rough bsdfs have a distribution of facets that is not supported"};
constexpr WarningKind kUnknownDistribution{
    Effect::Slight, "rough bsdfs have an unknown distribution of facets: ggx stands in"};
constexpr WarningKind kUnknownMetal{Effect::Surface, "metals are unknown: copper stands in"};
constexpr WarningKind kPhong{Effect::Slight, "Phong bsdfs are not supported: others stand in"};
constexpr WarningKind kFiber{Effect::Surface,
                             "bsdfs of fibers are not supported: diffuse ones stand in"};
constexpr WarningKind kNoInterference{Effect::Slight,
                                      "thin sheets have interference, which is not supported"};
constexpr WarningKind kThickness{Effect::Surface,
                                 "thin sheets have a textured thickness: 0.5 stands in"};
constexpr WarningKind kHalfTransmitted{
    Effect::Surface, "diffuse transmission has a share, though half is transmitted in any case"};
constexpr WarningKind kPartMedia{Effect::Surface,
                                 "parts of bsdfs have media, which do not count: ignored"};
constexpr WarningKind kNoPart{Effect::Surface, "bsdfs lack a part: grey stands in"};

desc::Node diffuse(const desc::Value& reflectance) {
  return desc::material_node("diffuse", {{"reflectance", reflectance}});
}

// ---------------------------------------------------------------- diffuse ones

desc::Node lambert(const BsdfInputs& in) { return diffuse(in.albedo()); }

desc::Node null_bsdf(const BsdfInputs& in) {
  in.object.accept({"albedo", "color"});
  return diffuse(Vec3(0.F));
}

desc::Node forward(const BsdfInputs& in) {
  in.object.accept({"albedo", "color"});
  // All surfaces are bounces.
  return desc::material_node("interface", {{"counted", true}});
}

desc::Node oren_nayar(const BsdfInputs& in) {
  // Tungsten's roughness 1 is a spread of 1/√2 radians.
  constexpr float kDegrees = 40.5142342F;
  return desc::material_node("diffuse",
                             {{"reflectance", in.albedo()},
                              {"sigma", in.textures.product(in.number("roughness", 1.F), kDegrees)},
                              {"between_facets", true}});
}

desc::Node diffuse_transmission(const BsdfInputs& in) {
  // No version of Tungsten that is known reads another share.
  constexpr float kShare = 0.5F;
  if (in.object.number("transmittance").value_or(kShare) != kShare) {
    in.warn(kHalfTransmitted,
            "Tungsten does not read \"transmittance\" and transmits half, as is done here");
  }
  return desc::material_node("translucent", {{"diffuse", in.albedo()},
                                             {"glossy", Vec3(0.F)},
                                             {"reflectance", Vec3(1.F - kShare)},
                                             {"transmittance", Vec3(kShare)}});
}

desc::Node fiber(const BsdfInputs& in) {
  in.warn(kFiber, "bsdfs of fibers are not supported: a diffuse one stands in");
  in.object.accept({"scale_angle", "melanin_ratio", "melanin_concentration", "override_sigma_a",
                    "sigma_a", "roughness", "material", "eta", "k"});
  return diffuse(in.object.has({"albedo", "color"}) ? in.albedo() : desc::Value(Vec3(0.5F)));
}

// ---------------------------------------------------------------- metals

ComplexIor complex_ior(const BsdfInputs& in) {
  const ComplexIor copper = *find_metal("Cu");
  const std::optional<Vec3> eta = in.object.vector("eta");
  const std::optional<Vec3> k = in.object.vector("k");
  const std::optional<std::string> name = in.object.text("material");
  if (name && !name->empty()) {
    if (const std::optional<ComplexIor> metal = find_metal(*name)) return *metal;
    in.warn(kUnknownMetal,
            unknown_name_message("metal", printable(*name), metal_names()) + ". Copper stands in");
    return copper;
  }
  return {eta.value_or(copper.eta), k.value_or(copper.k)};
}

desc::Node conductor(const BsdfInputs& in, const desc::Value& roughness, std::string distribution) {
  const ComplexIor ior = complex_ior(in);
  return in.tinted(desc::material_node("conductor", {{"eta", ior.eta},
                                                     {"k", ior.k},
                                                     {"roughness", roughness},
                                                     {"distribution", std::move(distribution)},
                                                     {"masking", kMasking}}),
                   in.albedo());
}

desc::Node smooth_conductor(const BsdfInputs& in) { return conductor(in, 0.F, "smooth"); }

desc::Node rough_conductor(const BsdfInputs& in) {
  return conductor(in, in.number("roughness", 0.1F), distribution_of(in));
}

desc::Node mirror(const BsdfInputs& in) {
  return desc::material_node("mirror", {{"reflectance", in.albedo()}});
}

// ---------------------------------------------------------------- glass

desc::Node dielectric_of(const BsdfInputs& in, const desc::Value& roughness) {
  const desc::Value tint = in.albedo();
  const bool refracts = in.object.flag("enable_refraction").value_or(true);
  return desc::material_node("dielectric",
                             {{"reflectance", tint},
                              {"transmittance", refracts ? tint : desc::Value(Vec3(0.F))},
                              {"eta", in.object.number("ior").value_or(1.5F)},
                              {"roughness", roughness},
                              {"masking", kMasking}});
}

desc::Node dielectric(const BsdfInputs& in) { return dielectric_of(in, 0.F); }

desc::Node rough_dielectric(const BsdfInputs& in) {
  desc::Node node = dielectric_of(in, in.number("roughness", 0.1F));
  node.set("distribution", distribution_of(in));
  return node;
}

desc::Node thin_sheet(const BsdfInputs& in) {
  const Vec3 sigma = in.object.vector("sigma_a").value_or(Vec3(0.F));
  const desc::Value thickness = in.number("thickness", 0.5F);
  if (in.object.flag("enable_interference").value_or(false)) {
    in.warn(kNoInterference, "interference of thin sheets is not supported: left out");
  }
  const float* constant = std::get_if<float>(&thickness);
  const float depth = 2.F * (constant != nullptr ? *constant : 0.5F);
  in.object.accept({"albedo", "color"});
  if (constant == nullptr && sigma != Vec3(0.F)) {
    in.warn(kThickness, "a texture of \"thickness\" is not supported: 0.5 stands in");
  }
  const Vec3 left(std::exp(-sigma.x * depth), std::exp(-sigma.y * depth),
                  std::exp(-sigma.z * depth));
  return desc::material_node("dielectric", {{"transmittance", left},
                                            {"eta", in.object.number("ior").value_or(1.5F)},
                                            {"thin", true},
                                            {"polarised", true},
                                            {"along_normal", true}});
}

// ---------------------------------------------------------------- mixtures

desc::Node mixed(const BsdfInputs& in) {
  const auto part = [&](std::string_view name) {
    if (const std::optional<desc::MaterialId> found = in.part(name)) {
      return part_of_mix(in.context.scene, *found);
    }
    in.warn(kNoPart, "\"" + std::string(name) + "\" is missing: grey stands in");
    return in.add(desc::material_node("diffuse"));
  };
  const desc::MaterialId first = part("bsdf0");
  const desc::MaterialId second = part("bsdf1");
  desc::Value ratio = in.number("ratio", 0.5F);
  if (const float* share = std::get_if<float>(&ratio)) ratio = Vec3(*share);
  return in.tinted(desc::material_node("mix", {{"amount", ratio},
                                               {"first", desc::MaterialRef{first}},
                                               {"second", desc::MaterialRef{second}}}),
                   in.albedo());
}

desc::Node phong(const BsdfInputs& in) {
  in.warn(kPhong,
          "Phong's bsdf is not supported: a diffuse base under a gloss of about the same "
          "width stands in");
  const float exponent = std::max(in.object.number("exponent").value_or(64.F), 0.F);
  const float share = std::clamp(in.object.number("diffuse_ratio").value_or(0.2F), 0.F, 1.F);
  const desc::Value albedo = in.albedo();
  // Facets whose reflections are as wide as cosⁿ: one that turns by an angle turns its reflection
  // by twice as much, so their own exponent is 4n. Alpha of it: Walter et al. 2007, section 5.3.
  const float alpha = std::sqrt(2.F / (4.F * exponent + 2.F));
  return desc::material_node(
      "coated_diffuse", {{"diffuse_reflectance", in.textures.product(albedo, Vec3(share))},
                         {"glossy_reflectance", in.textures.product(albedo, Vec3(1.F - share))},
                         {"roughness", alpha}});
}

struct Entry {
  std::string_view type;
  desc::Node (*make)(const BsdfInputs& in);
};

constexpr std::array<Entry, 21> kModels = {{{"lambert", lambert},
                                            {"oren_nayar", oren_nayar},
                                            {"diffuse_transmission", diffuse_transmission},
                                            {"null", null_bsdf},
                                            {"error", null_bsdf},
                                            {"forward", forward},
                                            {"mirror", mirror},
                                            {"conductor", smooth_conductor},
                                            {"rough_conductor", rough_conductor},
                                            {"dielectric", dielectric},
                                            {"rough_dielectric", rough_dielectric},
                                            {"thinsheet", thin_sheet},
                                            {"plastic", plastic},
                                            {"rough_plastic", rough_plastic},
                                            {"smooth_coat", smooth_coat},
                                            {"rough_coat", rough_coat},
                                            {"mixed", mixed},
                                            {"phong", phong},
                                            {"lambertian_fiber", fiber},
                                            {"hair", fiber},
                                            {"rough_wire", fiber}}};

}  // namespace

std::string distribution_of(const BsdfInputs& in) {
  const std::string name = in.object.text("distribution").value_or("ggx");
  if (name == "ggx" || name == "beckmann") return name;
  if (name == "phong") {
    in.warn(kDistribution,
            "the distribution \"phong\" is not supported: \"beckmann\", which is near, stands in");
    return "beckmann";
  }
  static const std::vector<std::string> kKnown = {"beckmann", "ggx", "phong"};
  in.warn(kUnknownDistribution,
          unknown_name_message("distribution", printable(name), kKnown) + ". \"ggx\" stands in");
  return "ggx";
}

std::optional<desc::MaterialId> BsdfInputs::part(std::string_view name) const {
  const auto json = object.find(name);
  if (!json) return std::nullopt;
  const Surface surface = bsdfs.resolve(*json);
  if (surface.inside || surface.outside) {
    context.warnings.add(kPartMedia, json->where(),
                         "the media of a part of a bsdf are ignored: those of the whole count, "
                         "and those of the primitive");
  }
  return bsdfs.without_relief(surface.material);
}

desc::Node BsdfInputs::tinted(desc::Node node, const desc::Value& tint) const {
  if (tint == desc::Value(Vec3(1.F))) return node;
  return desc::material_node("mix", {{"amount", tint},
                                     {"first", desc::MaterialRef{add(std::move(node))}},
                                     {"second", desc::MaterialRef{bsdfs.black()}}});
}

std::optional<desc::Node> make_bsdf(const std::string& type, const BsdfInputs& in) {
  for (const Entry& entry : kModels) {
    if (entry.type == type) return entry.make(in);
  }
  return std::nullopt;
}

std::vector<std::string> bsdf_types() {
  std::vector<std::string> types = {"transparency"};
  for (const Entry& entry : kModels) types.emplace_back(entry.type);
  return types;
}

}  // namespace ajar::tungsten
