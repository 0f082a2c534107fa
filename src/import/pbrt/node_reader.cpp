#include "import/pbrt/node_reader.h"

#include <algorithm>

#include "import/pbrt/own_words.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnknownValue{Effect::Surface,
                                    "parameters have unknown values: their defaults stand in"};

}  // namespace

const desc::Model* model_of_type(desc::ModelKind kind, std::span<const ModelName> table,
                                 std::string_view type) {
  if (const ModelName* names = find_theirs(table, type)) return desc::find_model(kind, names->ours);
  return find_ours(table, type) == nullptr ? desc::find_model(kind, type) : nullptr;
}

const desc::Model* own_model(const Context& context, const SourceLocation& where,
                             desc::ModelKind kind, const std::optional<std::string>& own) {
  if (context.is_v4() || !own || own->empty()) return nullptr;
  const desc::Model* model = desc::find_model(kind, *own);
  if (model == nullptr) fail_unknown(where, "model of Ajar", *own, types_of(kind, {}));
  return model;
}

std::vector<std::string> types_of(desc::ModelKind kind, std::span<const ModelName> table) {
  std::vector<std::string> types;
  const auto add = [&](std::string_view type) {
    if (type.empty() || std::find(types.begin(), types.end(), type) != types.end()) return;
    types.emplace_back(type);
  };
  for (const ModelName& name : table) add(name.theirs);
  for (const desc::Model* model : desc::models(kind)) {
    if (find_ours(table, model->name) == nullptr) add(model->name);
  }
  return types;
}

desc::Node NodeReader::read(const desc::Model& model, const ModelName* names) const {
  desc::Node node(model);
  for (const ParameterSpec& spec : model.parameters) {
    const bool is_elsewhere = spec.type == ParameterType::Transform ||
                              spec.type == ParameterType::Mesh ||
                              spec.type == ParameterType::Curves;
    if (is_elsewhere || !node.matters(spec)) continue;
    const ParameterName* translated = names == nullptr ? nullptr : names->find(spec.name);
    const ParameterName same{spec.name, {spec.name}};
    node.set(spec.name, value(spec, translated == nullptr ? same : *translated));
  }
  return node;
}

desc::Value NodeReader::value(const ParameterSpec& spec, const ParameterName& name) const {
  // References of mixes are found by pbrt's words.
  const bool may_be_own = has_own_words_ && spec.type != ParameterType::Material;
  if (may_be_own) {
    const std::string own = own_word(spec.name);
    if (const std::optional<desc::Value> given = find(spec, own)) return allowed(spec, own, *given);
  }
  for (const std::string_view theirs : name.theirs) {
    std::optional<desc::Value> given;
    if (name.words[0].empty()) {
      given = find(spec, theirs);
    } else if (const std::optional<bool> flag = parameters_.flag(theirs)) {
      given = std::string(name.words[*flag ? 1 : 0]);
    }
    if (!given) continue;
    return allowed(spec, theirs, *given);
  }
  // Where theirs is a flag, ours may have more to choose from.
  if (!name.words[0].empty()) {
    if (const std::optional<desc::Value> given = find(spec, spec.name)) return *given;
  }
  if (name.fallback.empty()) return desc::default_value(spec);
  ParameterSpec with_fallback = spec;
  with_fallback.default_value = name.fallback;
  return desc::default_value(with_fallback);
}

desc::Value NodeReader::allowed(const ParameterSpec& spec, std::string_view name,
                                const desc::Value& given) const {
  if (const std::optional<std::string> reason = desc::complaint(spec, given)) {
    throw SceneError(where_, "\"" + std::string(name) + "\" " + *reason);
  }
  return given;
}

std::optional<desc::Value> NodeReader::find(const ParameterSpec& spec,
                                            std::string_view name) const {
  const auto found = [](auto value) {
    return value ? std::optional<desc::Value>(std::move(*value)) : std::nullopt;
  };
  switch (spec.type) {
    case ParameterType::Bool:
      return found(parameters_.flag(name));
    case ParameterType::Int:
      return found(parameters_.integer(name));
    case ParameterType::Float:
      return spec.textured ? parameters_.find_number(name) : found(parameters_.number(name));
    case ParameterType::Color:
      return find_color(spec, name);
    case ParameterType::Vector:
      return found(parameters_.vector(name));
    case ParameterType::Point:
      return found(parameters_.point(name));
    case ParameterType::File:
      return find_file(name);
    case ParameterType::Text:
      return found(parameters_.text(name));
    case ParameterType::Choice:
      if (const std::optional<std::string> given = parameters_.text(name)) {
        return choice(spec, name, *given);
      }
      return std::nullopt;
    case ParameterType::Material:
      return desc::MaterialRef{find_material_(name)};
    case ParameterType::Transform:
    case ParameterType::Mesh:
    case ParameterType::Curves:
      break;
  }
  return std::nullopt;
}

std::optional<desc::Value> NodeReader::find_color(const ParameterSpec& spec,
                                                  std::string_view name) const {
  if (!numbers_for_colors_) {
    const bool positive = spec.minimum >= 0.0;
    if (spec.textured) return parameters_.find_spectrum(name, positive);
    const std::optional<desc::Rgb> color = parameters_.color(name, positive);
    return color ? std::optional<desc::Value>(*color) : std::nullopt;
  }
  if (!spec.textured) {
    const std::optional<float> number = parameters_.number(name);
    return number ? std::optional<desc::Value>(Vec3(*number)) : std::nullopt;
  }
  std::optional<desc::Value> found = parameters_.find_number(name);
  if (!found) return std::nullopt;
  if (const float* number = std::get_if<float>(&*found)) return Vec3(*number);
  return found;
}

std::optional<desc::Value> NodeReader::find_file(std::string_view name) const {
  const std::optional<std::string> given = parameters_.text(name);
  if (!given || given->empty()) return std::nullopt;
  return resolve_file(parameters_.context(), where_, *given);
}

std::string NodeReader::choice(const ParameterSpec& spec, std::string_view name,
                               const std::string& given) const {
  if (std::find(spec.choices.begin(), spec.choices.end(), given) != spec.choices.end()) {
    return given;
  }
  report_unknown(parameters_.context(), where_, "value of \"" + std::string(name) + "\"", given,
                 spec.choices, kUnknownValue, "\"" + spec.default_value + "\" stands in");
  return spec.default_value;
}

}  // namespace ajar::pbrt
