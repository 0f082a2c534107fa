#include "scene/desc/node.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "core/error.h"

namespace ajar::desc {
namespace {

[[noreturn]] void fail(const ParameterSpec& spec, const std::string& what) {
  throw std::logic_error("parameter \"" + spec.name + "\" " + what);
}

/// The numbers of a text, separated by single spaces.
std::vector<float> numbers_of(const ParameterSpec& spec) {
  std::vector<float> numbers;
  const char* at = spec.default_value.data();
  const char* const end = at + spec.default_value.size();
  while (at < end) {
    float number = 0.F;
    const auto [stop, status] = std::from_chars(at, end, number);
    if (status != std::errc() || (stop < end && *stop != ' ')) fail(spec, "has no such default");
    numbers.push_back(number);
    at = stop + 1;
  }
  return numbers;
}

std::string text_of(float value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr};
}

bool is_of_type(const ParameterSpec& spec, const Value& value) {
  if (std::holds_alternative<std::monostate>(value)) return spec.default_value.empty();
  if (std::holds_alternative<TextureRef>(value)) return spec.textured;
  switch (spec.type) {
    case ParameterType::Bool:
      return std::holds_alternative<bool>(value);
    case ParameterType::Int:
      return std::holds_alternative<int>(value);
    case ParameterType::Float:
      return std::holds_alternative<float>(value);
    case ParameterType::Text:
    case ParameterType::Choice:
    case ParameterType::File:
      return std::holds_alternative<std::string>(value);
    case ParameterType::Color:
    case ParameterType::Vector:
    case ParameterType::Point:
      return std::holds_alternative<Vec3>(value);
    case ParameterType::Transform:
      return std::holds_alternative<TransformPointer>(value) &&
             std::get<TransformPointer>(value) != nullptr;
    case ParameterType::Material:
      return std::holds_alternative<MaterialRef>(value);
    case ParameterType::Mesh:
      return std::holds_alternative<MeshPointer>(value);
    case ParameterType::Curves:
      return std::holds_alternative<CurvesPointer>(value);
  }
  return false;
}

}  // namespace

Value default_value(const ParameterSpec& spec) {
  const std::string& text = spec.default_value;
  switch (spec.type) {
    case ParameterType::Text:
    case ParameterType::Choice:
    case ParameterType::File:
      return text;
    case ParameterType::Mesh:
      return MeshPointer();
    case ParameterType::Curves:
      return CurvesPointer();
    case ParameterType::Transform: {
      static const auto kIdentity = std::make_shared<const Mat4>();
      return kIdentity;
    }
    default:
      break;
  }
  if (text.empty()) return {};
  if (spec.type == ParameterType::Bool) return text == "true";
  const std::vector<float> numbers = numbers_of(spec);
  if (spec.type == ParameterType::Int) return static_cast<int>(numbers.at(0));
  if (spec.type == ParameterType::Float) return numbers.at(0);
  if (spec.type == ParameterType::Color && numbers.size() == 1) return Vec3(numbers[0]);
  if (spec.type != ParameterType::Material && numbers.size() == 3) {
    return Vec3(numbers[0], numbers[1], numbers[2]);
  }
  fail(spec, "has no such default");
}

std::optional<std::string> complaint(const ParameterSpec& spec, const Value& value) {
  if (!is_of_type(spec, value)) fail(spec, "is of another type");
  const auto beyond = [&](const std::string& given) {
    const std::string range = range_text(spec);
    return "must be " + (range.empty() ? "a finite number" : range) + ", not " + given;
  };
  if (spec.textured) return std::nullopt;
  if (const int* number = std::get_if<int>(&value); number && !in_range(spec, *number)) {
    return beyond(std::to_string(*number));
  }
  if (const float* number = std::get_if<float>(&value); number && !in_range(spec, *number)) {
    return beyond(text_of(*number));
  }
  if (const Vec3* lanes = std::get_if<Vec3>(&value)) {
    for (const float lane : {lanes->x, lanes->y, lanes->z}) {
      if (!in_range(spec, lane)) return beyond(text_of(lane));
    }
  }
  if (const auto* text = std::get_if<std::string>(&value);
      text != nullptr && spec.type == ParameterType::Choice &&
      std::find(spec.choices.begin(), spec.choices.end(), *text) == spec.choices.end()) {
    std::string words;
    for (const std::string& word : spec.choices) words += (words.empty() ? "" : ", ") + word;
    return "must be one of " + words + ", not \"" + *text + "\"";
  }
  return std::nullopt;
}

Node::Node(const Model& model, Given given) : model_(&model) {
  values_.reserve(model.parameters.size());
  for (const ParameterSpec& spec : model.parameters) values_.push_back(default_value(spec));
  for (const auto& [name, value] : given) set(name, value);
}

const ParameterSpec* Node::find(std::string_view name) const {
  if (!has_model()) return nullptr;
  for (const ParameterSpec& spec : model_->parameters) {
    if (spec.name == name) return &spec;
  }
  return nullptr;
}

std::size_t Node::position(std::string_view name) const {
  if (const ParameterSpec* spec = find(name)) {
    return static_cast<std::size_t>(spec - model_->parameters.data());
  }
  throw std::logic_error((has_model() ? model_->name : "a node of no model") +
                         " has no parameter \"" + std::string(name) + "\"");
}

void Node::set(std::string_view name, Value value) {
  const std::size_t i = position(name);
  if (const std::optional<std::string> reason = complaint(model_->parameters[i], value)) {
    throw SceneError("\"" + std::string(name) + "\" of " + model_->name + " " + *reason);
  }
  values_[i] = std::move(value);
}

const Value& Node::get(std::string_view name) const { return values_[position(name)]; }

bool Node::matters(const ParameterSpec& spec) const {
  return spec.depends_on.empty() || spec.matters_with(text(spec.depends_on));
}

std::vector<std::string> Node::files() const {
  std::vector<std::string> files;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (model_->parameters[i].type != ParameterType::File) continue;
    files.push_back(std::get<std::string>(values_[i]));
  }
  return files;
}

}  // namespace ajar::desc
