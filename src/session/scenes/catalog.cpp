#include "session/scenes/catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "import/format.h"
#include "integrator/integrator.h"
#include "scene/desc/models.h"
#include "session/scenes/builtin_scenes.h"

namespace ajar {

namespace {

using Json = nlohmann::ordered_json;

std::string with_words(std::string text, const ParameterSpec& spec) {
  for (const std::string& word : spec.choices) text.append(text.empty() ? "" : "|").append(word);
  return text;
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
    case ParameterType::Color:
      return "color";
    case ParameterType::Vector:
      return "vector";
    case ParameterType::Point:
      return "point";
    case ParameterType::Transform:
      return "transform";
    case ParameterType::File:
      return "file";
    case ParameterType::Material:
      return "material";
    case ParameterType::Mesh:
      return "mesh";
    case ParameterType::Curves:
      return "curves";
  }
  return {};
}

std::string type_text(const ParameterSpec& spec) {
  const std::string or_texture = spec.textured ? "|texture" : "";
  switch (spec.type) {
    case ParameterType::Bool:
      return "true|false";
    case ParameterType::Int:
      return "whole number";
    case ParameterType::Float:
      return with_words("number", spec) + or_texture;
    case ParameterType::Choice:
      return with_words("", spec);
    case ParameterType::Color:
      return "colour" + or_texture;
    default:
      return type_name(spec.type);
  }
}

Json parameter_json(const ParameterSpec& spec) {
  Json json{{"name", spec.name}, {"type", type_name(spec.type)}, {"default", spec.default_value},
            {"unit", spec.unit}, {"expert", spec.expert},        {"help", spec.help}};
  if (!spec.choices.empty()) json["choices"] = spec.choices;
  if (spec.minimum > -1e300) json["minimum"] = spec.minimum;
  if (spec.maximum < 1e300) json["maximum"] = spec.maximum;
  if (spec.textured) json["textured"] = true;
  if (!spec.depends_on.empty()) {
    json["depends_on"] = spec.depends_on;
    json["matters_for"] = spec.matters_for;
  }
  return json;
}

/// Kinds that scenes are described with.
const std::map<std::string, desc::ModelKind>& model_kinds() {
  static const std::map<std::string, desc::ModelKind> kinds{
      {"materials", desc::ModelKind::Material},
      {"textures", desc::ModelKind::Texture},
      {"lights", desc::ModelKind::Light},
      {"emissions", desc::ModelKind::Emission},
      {"shapes", desc::ModelKind::Shape}};
  return kinds;
}

/// Something that has parameters.
struct Parametrised {
  std::string name, summary, source;
  std::span<const ParameterSpec> parameters;
};

std::vector<Parametrised> parametrised(const std::string& kind) {
  std::vector<Parametrised> list;
  if (kind == "integrators") {
    for (const IntegratorInfo& info : integrators()) {
      list.push_back({info.name, info.summary, info.source, info.parameters});
    }
  } else if (const auto found = model_kinds().find(kind); found != model_kinds().end()) {
    for (const desc::Model* model : desc::models(found->second)) {
      list.push_back({model->name, model->summary, model->source, model->parameters});
    }
  }
  return list;
}

Parametrised find_parametrised(const std::string& kind, const std::string& name) {
  const std::vector<Parametrised> list = parametrised(kind);
  if (list.empty()) {
    throw UsageError("ajar list " + kind + " says all there is; its entries have no parameters");
  }
  std::vector<std::string> names;
  for (const Parametrised& entry : list) {
    if (entry.name == name) return entry;
    names.push_back(entry.name);
  }
  throw UsageError(unknown_name_message(kind.substr(0, kind.size() - 1), name, names));
}

Json to_json(const Parametrised& entry) {
  Json parameters = Json::array();
  for (const ParameterSpec& spec : entry.parameters) parameters.push_back(parameter_json(spec));
  return {{"name", entry.name},
          {"summary", entry.summary},
          {"source", entry.source},
          {"parameters", parameters}};
}

std::vector<CatalogEntry> format_catalog() {
  std::vector<CatalogEntry> entries;
  for (const Format& format : formats()) {
    entries.push_back(
        {format.name, fmt::format("{} ({}; {})", format.summary, fmt::join(format.extensions, ", "),
                                  format.write != nullptr ? "read and written" : "read")});
  }
  return entries;
}

std::vector<CatalogEntry> entries(const std::string& kind) {
  if (kind == "scenes") return scene_catalog();
  if (kind == "formats") return format_catalog();
  std::vector<CatalogEntry> layers;
  for (const Parametrised& entry : parametrised(kind))
    layers.push_back({entry.name, entry.summary});
  if (kind != "aovs") return layers;
  for (const AovInfo& aov : aovs()) {
    layers.push_back({aov.name, aov.summary + (aov.part_of_all ? "" : "; not part of \"all\"")});
  }
  return layers;
}

/// "with mapping=uv|planar", or empty.
std::string condition_text(const ParameterSpec& spec) {
  if (spec.depends_on.empty()) return {};
  return fmt::format("  with {}={}", spec.depends_on, fmt::join(spec.matters_for, "|"));
}

/// Description behind the name of a parameter: "=0.5 degrees  [number, between 0 and 90]".
std::string value_text(const ParameterSpec& spec) {
  const bool has_default = !spec.default_value.empty() || spec.type == ParameterType::Text;
  const std::string value = has_default ? "=" + spec.default_value : "";
  const std::string bounds = range_text(spec);
  return fmt::format("{}{}  [{}{}]{}", value, spec.unit.empty() ? "" : " " + spec.unit,
                     type_text(spec), bounds.empty() ? "" : ", " + bounds, condition_text(spec));
}

std::string parameters_text(std::span<const ParameterSpec> parameters, bool expert) {
  std::string text;
  for (const ParameterSpec& spec : parameters) {
    if (spec.expert != expert) continue;
    text += fmt::format("  {}{}\n      {}\n", spec.name, value_text(spec), spec.help);
  }
  return text;
}

}  // namespace

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
  valid.push_back("all");
  std::vector<std::string> chosen;
  const auto add = [&](const std::string& name) {
    if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
  };
  for (const std::string& name : names) {
    if (std::find(valid.begin(), valid.end(), name) == valid.end()) {
      throw UsageError(unknown_name_message("AOV", name, valid));
    }
    if (name == "all") {
      std::for_each(all.begin(), all.end(), add);
    } else {
      add(name);
    }
  }
  return chosen;
}

const std::vector<std::string>& catalog_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> all{"integrators"};
    for (const auto& [name, kind] : model_kinds()) all.push_back(name);
    all.insert(all.end(), {"aovs", "formats", "scenes"});
    return all;
  }();
  return kinds;
}

std::vector<std::string> names_with_parameters() {
  std::vector<std::string> names;
  for (const std::string& kind : catalog_kinds()) {
    for (const Parametrised& entry : parametrised(kind)) names.push_back(entry.name);
  }
  return names;
}

std::vector<std::string> kinds_with(const std::string& name) {
  std::vector<std::string> found;
  for (const std::string& kind : catalog_kinds()) {
    const std::vector<Parametrised> list = parametrised(kind);
    if (std::any_of(list.begin(), list.end(),
                    [&](const Parametrised& entry) { return entry.name == name; })) {
      found.push_back(kind);
    }
  }
  return found;
}

std::string catalog_text(const std::string& kind) {
  std::string text = kind + ":\n";
  for (const CatalogEntry& entry : entries(kind)) {
    text += fmt::format("  {:<20}  {}\n", entry.name, entry.summary);
  }
  if (!parametrised(kind).empty()) {
    text +=
        fmt::format("\najar list {} NAME shows the parameters of one, --json those of all\n", kind);
  }
  return text;
}

Json catalog_json(const std::string& kind) {
  Json list = Json::array();
  for (const Parametrised& entry : parametrised(kind)) list.push_back(to_json(entry));
  if (!list.empty()) return list;
  for (const CatalogEntry& entry : entries(kind)) {
    list.push_back({{"name", entry.name}, {"summary", entry.summary}});
  }
  return list;
}

std::string entry_text(const std::string& kind, const std::string& name) {
  const Parametrised entry = find_parametrised(kind, name);
  std::string text = fmt::format("{}: {}\n", entry.name, entry.summary);
  if (!entry.source.empty()) text += fmt::format("  ({})\n", entry.source);
  const std::string basic = parameters_text(entry.parameters, false);
  const std::string expert = parameters_text(entry.parameters, true);
  const char* how = kind == "integrators" ? " (--set NAME=VALUE)" : "";
  if (!basic.empty()) {
    text += fmt::format("\nparameters{}, with their defaults:\n", how) + basic;
  }
  if (!expert.empty()) text += "\nexpert parameters:\n" + expert;
  return text;
}

Json entry_json(const std::string& kind, const std::string& name) {
  return to_json(find_parametrised(kind, name));
}

}  // namespace ajar
