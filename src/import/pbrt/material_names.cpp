#include "import/pbrt/material_names.h"

namespace ajar::pbrt {
namespace {

// Names and defaults: pbrt-v3, src/materials/*.cpp; pbrt-v4, src/pbrt/materials.cpp.

const ParameterName kRemapped{"roughness_scale", {"remaproughness"}, "log", {"alpha", "log"}};
const ParameterName kSquared{"roughness_scale", {"remaproughness"}, "square", {"alpha", "square"}};
const ParameterName kDiffuse{"diffuse_reflectance", {"Kd"}};
const ParameterName kGlossy{"glossy_reflectance", {"Ks"}};
const ParameterName kIndex{"eta", {"eta", "index"}};
/// pbrt-v4 loses light that meets more than one facet of a coat.
const ParameterName kLossy{"coat_transmission", {}, "lossy"};

/// pbrt gives both roughnesses a value of their own.
ParameterName roughness_v(std::vector<std::string_view> theirs, std::string_view fallback) {
  return {"roughness_v", std::move(theirs), fallback, {}, "roughness"};
}

/// pbrt-v4's two roughnesses of one layer, whose names start with `layer`.
std::vector<ParameterName> layer_roughness(std::string_view ours, std::string_view ours_v,
                                           std::array<std::string_view, 3> theirs) {
  return {{ours, {theirs[0], theirs[2]}, "0"}, {ours_v, {theirs[1], theirs[2]}, "0"}};
}
std::vector<ParameterName> with_roughness(std::vector<ParameterName> parameters) {
  for (ParameterName& name :
       layer_roughness("roughness", "roughness_v", {"uroughness", "vroughness", "roughness"})) {
    parameters.push_back(std::move(name));
  }
  parameters.push_back(kSquared);
  return parameters;
}
std::vector<ParameterName> coated_conductor() {
  std::vector<ParameterName> parameters =
      layer_roughness("roughness", "roughness_v",
                      {"conductor.uroughness", "conductor.vroughness", "conductor.roughness"});
  for (ParameterName& name :
       layer_roughness("coat_roughness", "coat_roughness_v",
                       {"interface.uroughness", "interface.vroughness", "interface.roughness"})) {
    parameters.push_back(std::move(name));
  }
  parameters.push_back({"eta", {"conductor.eta"}});
  parameters.push_back({"k", {"conductor.k"}});
  parameters.push_back({"coat_eta", {"interface.eta"}});
  for (const char* name :
       {"coat_depth", "bounces", "distribution", "coat_distribution", "masking"}) {
    parameters.push_back({name, {}});
  }
  parameters.push_back(kLossy);
  parameters.push_back(kSquared);
  return parameters;
}

}  // namespace

namespace {

const std::vector<ModelName>& materials_of_v3() {
  static const std::vector<ModelName> kNames = {
      {"matte", "diffuse", {{"reflectance", {"Kd"}}}},
      {"mirror", "mirror", {{"reflectance", {"Kr"}}}},
      {"glass",
       "dielectric",
       {{"reflectance", {"Kr"}},
        {"transmittance", {"Kt"}},
        kIndex,
        {"roughness", {"uroughness"}},
        roughness_v({"vroughness"}, "0"),
        kRemapped}},
      {"metal",
       "conductor",
       {{"roughness", {"uroughness", "roughness"}},
        roughness_v({"vroughness", "roughness"}, "0.01"),
        kRemapped}},
      {"plastic", "plastic", {kDiffuse, kGlossy, kRemapped}},
      {"substrate",
       "coated_diffuse",
       {kDiffuse,
        kGlossy,
        {"roughness", {"uroughness"}},
        roughness_v({"vroughness"}, "0.1"),
        kRemapped}},
      {"uber",
       "composite",
       {kDiffuse,
        kGlossy,
        {"mirror_reflectance", {"Kr"}},
        {"transmittance", {"Kt"}},
        kIndex,
        {"roughness", {"uroughness", "roughness"}},
        roughness_v({"vroughness", "roughness"}, "0.1"),
        kRemapped}},
      {"translucent",
       "translucent",
       {{"diffuse", {"Kd"}},
        {"glossy", {"Ks"}},
        {"reflectance", {"reflect"}},
        {"transmittance", {"transmit"}},
        kRemapped}},
      {"disney",
       "principled",
       {{"base_color", {"color"}},
        {"specular_tint", {"speculartint"}},
        {"sheen_tint", {"sheentint"}},
        {"clearcoat_gloss", {"clearcoatgloss"}},
        {"specular_transmission", {"spectrans"}},
        {"diffuse_transmission", {"difftrans"}},
        {"blend", {"blend"}, "twice"}}},
      {"mix", "mix", {{"first", {"namedmaterial1"}}, {"second", {"namedmaterial2"}}}},
      {"none", "interface", {}},
      {"", "interface", {}}};
  return kNames;
}

const std::vector<ModelName>& materials_of_v4() {
  // Parameters that v4 materials imply by their type.
  static const ParameterName kNoTint{"reflectance", {}};
  static const ParameterName kNoTransmittance{"transmittance", {}};
  static const ParameterName kFacets{"distribution", {}};
  static const ParameterName kMasking{"masking", {}};
  static const ParameterName kNotPolarised{"polarised", {}};
  static const ParameterName kNotSlanted{"along_normal", {}};
  static const std::vector<ModelName> kNames = {
      {"diffuse", "diffuse", {}},
      {"conductor", "conductor", with_roughness({kFacets, kMasking})},
      {"dielectric", "dielectric",
       with_roughness({kNoTint,
                       kNoTransmittance,
                       {"thin", {}},
                       kFacets,
                       kMasking,
                       kNotPolarised,
                       kNotSlanted})},
      {"thindielectric",
       "dielectric",
       {kNoTint,
        kNoTransmittance,
        {"thin", {}, "true"},
        kFacets,
        kMasking,
        kNotPolarised,
        kNotSlanted,
        {"roughness", {}},
        {"roughness_v", {}},
        {"roughness_scale", {}}}},
      {"coateddiffuse", "coated_diffuse",
       with_roughness({{"diffuse_reflectance", {"reflectance"}},
                       {"coat", {}, "dielectric"},
                       {"coat_reflectance", {}},
                       {"coat_depth", {}},
                       {"coat_ways", {}},
                       {"bounces", {}},
                       {"inner_reflections", {}},
                       kFacets,
                       kMasking,
                       kLossy})},
      {"coatedconductor", "coated_conductor", coated_conductor()},
      {"diffusetransmission",
       "translucent",
       {{"diffuse", {}, "1"},
        {"glossy", {}, "0"},
        {"reflectance", {"reflectance"}, "0.25"},
        {"transmittance", {"transmittance"}, "0.25"},
        {"roughness", {}},
        {"roughness_scale", {}}}},
      // "amount" is of the second there and of the first here; `materials.cpp` names them.
      {"mix", "mix", {}},
      {"interface", "interface", {}},
      {"none", "interface", {}},
      {"", "interface", {}}};
  return kNames;
}

}  // namespace

const std::vector<ModelName>& material_names(Dialect dialect) {
  return dialect == Dialect::V3 ? materials_of_v3() : materials_of_v4();
}

}  // namespace ajar::pbrt
