#include "import/pbrt/material_names.h"

namespace ajar::pbrt {
namespace {

// Names and defaults: pbrt-v3, src/materials/*.cpp.

const ParameterName kRemapped{"roughness_scale", {"remaproughness"}, "log", {"alpha", "log"}};
const ParameterName kDiffuse{"diffuse_reflectance", {"Kd"}};
const ParameterName kGlossy{"glossy_reflectance", {"Ks"}};
const ParameterName kIndex{"eta", {"eta", "index"}};

/// pbrt gives both roughnesses a value of their own.
ParameterName roughness_v(std::vector<std::string_view> theirs, std::string_view fallback) {
  return {"roughness_v", std::move(theirs), fallback, {}, "roughness"};
}

constexpr std::array<StandIn, 4> kStandIns = {{{"fourier", "", 0.5F},
                                               {"hair", "color", 0.2F},
                                               {"subsurface", "", 0.5F},
                                               {"kdsubsurface", "Kd", 0.5F}}};

}  // namespace

const std::vector<ModelName>& material_names() {
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
        {"diffuse_transmission", {"difftrans"}}}},
      {"mix", "mix", {{"first", {"namedmaterial1"}}, {"second", {"namedmaterial2"}}}},
      {"none", "interface", {}},
      {"", "interface", {}}};
  return kNames;
}

const StandIn* find_stand_in(std::string_view type) {
  const auto found = std::find_if(kStandIns.begin(), kStandIns.end(),
                                  [&](const StandIn& known) { return known.type == type; });
  return found == kStandIns.end() ? nullptr : &*found;
}

std::vector<std::string> stand_in_types() {
  std::vector<std::string> types;
  for (const StandIn& known : kStandIns) types.emplace_back(known.type);
  return types;
}

}  // namespace ajar::pbrt
