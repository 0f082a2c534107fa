#include "session/catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "integrator/integrator.h"
#include "session/builtin_scenes.h"

namespace ajar {

namespace {

using Json = nlohmann::ordered_json;

std::string type_text(const ParameterSpec& spec) {
  switch (spec.type) {
    case ParameterType::Bool:
      return "true|false";
    case ParameterType::Int:
      return "whole number";
    case ParameterType::Float: {
      std::string text = "number";
      for (const std::string& word : spec.choices) text.append("|").append(word);
      return text;
    }
    case ParameterType::Text:
      return "text";
    case ParameterType::Choice: {
      std::string text;
      for (const std::string& choice : spec.choices) text += (text.empty() ? "" : "|") + choice;
      return text;
    }
  }
  return {};
}

std::string type_name(ParameterType type) {
  switch (type) {
    case ParameterType::Bool:
      return "bool";
    case ParameterType::Int:
      return "int";
    case ParameterType::Float:
      return "float";
    case ParameterType::Text:
      return "text";
    case ParameterType::Choice:
      return "choice";
  }
  return {};
}

Json parameter_json(const ParameterSpec& spec) {
  Json json{{"name", spec.name}, {"type", type_name(spec.type)}, {"default", spec.default_value},
            {"unit", spec.unit}, {"expert", spec.expert},        {"help", spec.help}};
  if (!spec.choices.empty()) json["choices"] = spec.choices;
  if (spec.minimum > -1e300) json["minimum"] = spec.minimum;
  if (spec.maximum < 1e300) json["maximum"] = spec.maximum;
  return json;
}

std::vector<CatalogEntry> entries(const std::string& kind) {
  if (kind == "materials") return material_catalog();
  if (kind == "scenes") return scene_catalog();
  if (kind == "integrators") {
    std::vector<CatalogEntry> methods;
    for (const IntegratorInfo& info : integrators()) methods.push_back({info.name, info.summary});
    return methods;
  }
  std::vector<CatalogEntry> layers;
  for (const AovInfo& aov : aovs()) {
    layers.push_back({aov.name, aov.summary + (aov.part_of_all ? "" : "; not part of \"all\"")});
  }
  return layers;
}

std::string parameters_text(const IntegratorInfo& info, bool expert) {
  std::string text;
  for (const ParameterSpec& spec : info.parameters) {
    if (spec.expert != expert) continue;
    text += fmt::format("  {}={}{}  [{}]\n      {}\n", spec.name, spec.default_value,
                        spec.unit.empty() ? "" : " " + spec.unit, type_text(spec), spec.help);
  }
  return text;
}

}  // namespace

const std::vector<CatalogEntry>& material_catalog() {
  static const std::vector<CatalogEntry> entries{
      {"disney", "principled material of Burley 2012/2015"},
      {"glass", "smooth or rough dielectric boundary"},
      {"matte", "diffuse (Lambert), or rough diffuse (Oren-Nayar)"},
      {"metal", "rough conductor with a measured or given index of refraction"},
      {"mirror", "perfect mirror"},
      {"mix", "blend of two materials by a texture"},
      {"none", "no surface: only separates media"},
      {"plastic", "diffuse base with a rough dielectric gloss"},
      {"substrate", "diffuse base under a glossy coat (Ashikhmin-Shirley)"},
      {"translucent", "diffuse and glossy reflection and transmission"},
      {"uber", "diffuse, glossy, mirror and transparent parts with opacity"},
  };
  return entries;
}

std::vector<CatalogEntry> scene_catalog() {
  std::vector<CatalogEntry> entries;
  for (const std::string& name : builtin_scene_names()) {
    entries.push_back({"builtin:" + name, builtin_scene_summary(name)});
  }
  return entries;
}

std::vector<std::string> checked_aovs(const std::vector<std::string>& names) {
  std::vector<std::string> valid;
  std::vector<std::string> all;
  for (const AovInfo& aov : aovs()) {
    valid.push_back(aov.name);
    if (aov.part_of_all) all.push_back(aov.name);
  }
  if (names == std::vector<std::string>{"all"}) return all;
  for (const std::string& name : names) {
    if (std::find(valid.begin(), valid.end(), name) == valid.end()) {
      throw UsageError(unknown_name_message("AOV", name, valid));
    }
  }
  return names;
}

const std::vector<std::string>& catalog_kinds() {
  static const std::vector<std::string> kinds{"integrators", "materials", "aovs", "scenes"};
  return kinds;
}

std::string catalog_text(const std::string& kind) {
  std::string text = kind + ":\n";
  for (const CatalogEntry& entry : entries(kind)) {
    text += fmt::format("  {:<20}  {}\n", entry.name, entry.summary);
  }
  if (kind == "integrators") {
    text += "\najar list integrators NAME shows the parameters of one, --json those of all\n";
  }
  return text;
}

Json catalog_json(const std::string& kind) {
  Json list = Json::array();
  if (kind != "integrators") {
    for (const CatalogEntry& entry : entries(kind)) {
      list.push_back({{"name", entry.name}, {"summary", entry.summary}});
    }
    return list;
  }
  for (const IntegratorInfo& info : integrators()) list.push_back(integrator_json(info));
  return list;
}

std::string integrator_text(const IntegratorInfo& info) {
  std::string text = fmt::format("{}: {}\n", info.name, info.summary);
  if (!info.source.empty()) text += fmt::format("  ({})\n", info.source);
  const std::string basic = parameters_text(info, false);
  const std::string expert = parameters_text(info, true);
  if (!basic.empty()) text += "\nparameters (--set NAME=VALUE), with their defaults:\n" + basic;
  if (!expert.empty()) text += "\nexpert parameters:\n" + expert;
  return text;
}

Json integrator_json(const IntegratorInfo& info) {
  Json parameters = Json::array();
  for (const ParameterSpec& spec : info.parameters) parameters.push_back(parameter_json(spec));
  return {{"name", info.name},
          {"summary", info.summary},
          {"source", info.source},
          {"parameters", parameters}};
}

}  // namespace ajar
