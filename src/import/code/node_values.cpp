#include "import/code/node_values.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/number_text.h"

namespace ajar::code {

namespace {

using Json = nlohmann::ordered_json;
using Kind = LocatedJson::Kind;

/// Values allowed for a parameter, for messages.
std::string wanted(const ParameterSpec& spec) {
  const std::string or_texture = spec.textured ? " or a texture" : "";
  switch (spec.type) {
    case ParameterType::Bool:
      return "true or false";
    case ParameterType::Int:
      return "a whole number";
    case ParameterType::Float:
      return "a number" + or_texture;
    case ParameterType::Color:
      return "a number, three of them (red, green, blue)" + or_texture;
    case ParameterType::Vector:
    case ParameterType::Point:
      return "three numbers";
    case ParameterType::Transform:
      return "a matrix of 4 x 4 numbers";
    case ParameterType::Text:
    case ParameterType::Choice:
      return "text";
    case ParameterType::File:
      return "the name of a file or an array";
    case ParameterType::Material:
      return "a material";
    case ParameterType::Mesh:
      return "a mesh";
    case ParameterType::Curves:
      return "curves";
  }
  return {};
}

/// Reads the values of one node.
class ValueReader {
 public:
  ValueReader(const ArrayReader& arrays, const References& references)
      : arrays_(arrays), references_(references) {}

  desc::Value read(const ParameterSpec& spec, const LocatedJson& json) const {
    const bool is_object = json.is(Kind::Object);
    if (json.is(Kind::Null)) return desc::default_value(spec);
    if (is_object && json.has("texture") && spec.textured) {
      return desc::TextureRef{references_.texture(json.at("texture"))};
    }
    switch (spec.type) {
      case ParameterType::Bool:
        return json.flag();
      case ParameterType::Int:
        return json.as<int>();
      case ParameterType::Float:
        if (json.is(Kind::Number)) return json.as<float>();
        break;
      case ParameterType::Color:
        if (json.is(Kind::Number)) return Vec3(json.as<float>());
        [[fallthrough]];
      case ParameterType::Vector:
      case ParameterType::Point:
        if (json.is(Kind::Array) && json.size() == 3) return json.as<Vec3>();
        break;
      case ParameterType::Transform:
        return std::make_shared<const Mat4>(read_transform(json));
      case ParameterType::File:
        if (is_object) return arrays_.image(json);
        [[fallthrough]];
      case ParameterType::Text:
      case ParameterType::Choice:
        if (json.is(Kind::Text)) return json.text();
        break;
      case ParameterType::Material:
        if (is_object && json.has("material")) {
          return desc::MaterialRef{references_.material(json.at("material"))};
        }
        break;
      case ParameterType::Mesh:
        if (is_object) return arrays_.mesh(json);
        break;
      case ParameterType::Curves:
        if (is_object) return arrays_.curves(json);
        break;
    }
    json.fail_type(wanted(spec));
  }

 private:
  const ArrayReader& arrays_;
  const References& references_;
};

struct ValueWriter {
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(bool value) const { return value; }
  Json operator()(int value) const { return value; }
  Json operator()(float value) const { return decimal_of(value); }
  Json operator()(const Vec3& v) const {
    return {decimal_of(v.x), decimal_of(v.y), decimal_of(v.z)};
  }
  Json operator()(const std::string& value) const { return value; }
  Json operator()(desc::TextureRef ref) const { return {{"texture", ref.id}}; }
  Json operator()(desc::MaterialRef ref) const { return {{"material", ref.id}}; }
  Json operator()(const desc::TransformPointer& matrix) const {
    Json numbers = Json::array();
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) numbers.push_back((*matrix)[column][row]);
    }
    return numbers;
  }
  Json operator()(const desc::MeshPointer&) const { return nullptr; }
  Json operator()(const desc::CurvesPointer&) const { return nullptr; }
};

}  // namespace

const char* name_of(desc::ModelKind kind) {
  switch (kind) {
    case desc::ModelKind::Material:
      return "material";
    case desc::ModelKind::Texture:
      return "texture";
    case desc::ModelKind::Light:
      return "light";
    case desc::ModelKind::Emission:
      return "emission";
    case desc::ModelKind::Shape:
      return "shape";
  }
  return "";
}

desc::Node read_node(desc::ModelKind kind, const LocatedJson& json, const ArrayReader& arrays,
                     const References& references) {
  const std::string name = json.value_or("model", std::string());
  const desc::Model* model = desc::find_model(kind, name);
  if (model == nullptr) {
    std::vector<std::string> names;
    for (const desc::Model* known : desc::models(kind)) names.push_back(known->name);
    json.fail(unknown_name_message(name_of(kind), name, names));
  }
  desc::Node node(*model);
  set_parameters(kind, node, json, arrays, references);
  return node;
}

void set_parameters(desc::ModelKind kind, desc::Node& node, const LocatedJson& json,
                    const ArrayReader& arrays, const References& references) {
  const auto parameters = json.find("parameters");
  if (!parameters) return;
  std::vector<std::string> names;
  for (const ParameterSpec& known : node.model().parameters) names.push_back(known.name);
  parameters->check_members(
      "parameter of the " + std::string(name_of(kind)) + " \"" + node.model().name + "\"", names);
  const ValueReader reader(arrays, references);
  for (const auto& [name, key, given] : parameters->members()) {
    const auto place = std::find(names.begin(), names.end(), name) - names.begin();
    const ParameterSpec& spec = node.model().parameters[static_cast<std::size_t>(place)];
    desc::Value value = reader.read(spec, given);
    if (const auto reason = desc::complaint(spec, value)) given.fail(*reason);
    node.set(name, std::move(value));
  }
}

Mat4 read_transform(const LocatedJson& json) {
  if (!json.is(Kind::Array) || json.size() != 16) json.fail_type("a matrix of 4 x 4 numbers");
  const auto numbers = json.as<std::array<double, 16>>();
  Mat4 matrix;
  for (int i = 0; i < 16; ++i) matrix[i % 4][i / 4] = numbers[static_cast<std::size_t>(i)];
  return matrix;
}

Json node_json(const desc::Node& node) {
  Json parameters = Json::object();
  for (std::size_t i = 0; i < node.values().size(); ++i) {
    const ParameterSpec& spec = node.model().parameters[i];
    if (spec.type == ParameterType::Mesh || spec.type == ParameterType::Curves) continue;
    parameters[spec.name] = std::visit(ValueWriter(), node.values()[i]);
  }
  return {{"model", node.model().name}, {"parameters", parameters}};
}

}  // namespace ajar::code
