#include "import/code/node_values.h"

#include <cmath>
#include <limits>

#include "core/number_text.h"
#include "import/common/transforms.h"

namespace ajar::code {

namespace {

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
  ValueReader(const JsonPlace& place, const ArrayReader& arrays, const References& references)
      : place_(place), arrays_(arrays), references_(references) {}

  desc::Value read(const ParameterSpec& spec, const Json& json) const {
    if (json.is_null()) return desc::default_value(spec);
    if (json.is_object() && json.contains("texture")) {
      if (!spec.textured) fail(spec, json);
      return desc::TextureRef{references_.texture(json["texture"], place_)};
    }
    switch (spec.type) {
      case ParameterType::Bool:
        if (json.is_boolean()) return json.get<bool>();
        break;
      case ParameterType::Int:
        if (is_int(json)) return json.get<int>();
        break;
      case ParameterType::Float:
        if (json.is_number()) return json.get<float>();
        break;
      case ParameterType::Color:
        if (json.is_number()) return Vec3(json.get<float>());
        [[fallthrough]];
      case ParameterType::Vector:
      case ParameterType::Point:
        if (is_triple(json)) return Vec3(json[0], json[1], json[2]);
        break;
      case ParameterType::Transform:
        return std::make_shared<const Mat4>(read_transform(json, place_, spec.name.c_str()));
      case ParameterType::File:
        if (json.is_object()) return arrays_.image(json, place_);
        [[fallthrough]];
      case ParameterType::Text:
      case ParameterType::Choice:
        if (json.is_string()) return json.get<std::string>();
        break;
      case ParameterType::Material:
        if (json.is_object() && json.contains("material")) {
          return desc::MaterialRef{references_.material(json["material"], place_)};
        }
        break;
      case ParameterType::Mesh:
        if (json.is_object()) return arrays_.mesh(json, place_);
        break;
      case ParameterType::Curves:
        if (json.is_object()) return arrays_.curves(json, place_);
        break;
    }
    fail(spec, json);
  }

 private:
  static bool is_int(const Json& json) {
    return json.is_number_integer() &&
           std::abs(json.get<double>()) <= std::numeric_limits<int>::max();
  }
  static bool is_triple(const Json& json) {
    return json.is_array() && json.size() == 3 && json[0].is_number() && json[1].is_number() &&
           json[2].is_number();
  }
  [[noreturn]] void fail(const ParameterSpec& spec, const Json& json) const {
    place_.fail("\"" + spec.name + "\" must be " + wanted(spec) + ", not " + shown(json));
  }

  const JsonPlace& place_;
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

desc::Node read_node(desc::ModelKind kind, const JsonPlace& place, const ArrayReader& arrays,
                     const References& references) {
  const std::string name = place.text("model");
  const desc::Model* model = desc::find_model(kind, name);
  if (model == nullptr) {
    std::vector<std::string> names;
    for (const desc::Model* known : desc::models(kind)) names.push_back(known->name);
    place.fail(unknown_name_message(name_of(kind), name, names));
  }
  desc::Node node(*model);
  set_parameters(kind, node, place, arrays, references);
  return node;
}

void set_parameters(desc::ModelKind kind, desc::Node& node, const JsonPlace& place,
                    const ArrayReader& arrays, const References& references) {
  const Json* parameters = place.find("parameters");
  if (parameters == nullptr) return;
  if (!parameters->is_object()) place.fail("\"parameters\" must be an object");
  const ValueReader reader(place, arrays, references);
  for (const auto& [name, json] : parameters->items()) {
    const ParameterSpec* spec = nullptr;
    std::vector<std::string> names;
    for (const ParameterSpec& known : node.model().parameters) {
      if (known.name == name) spec = &known;
      names.push_back(known.name);
    }
    if (spec == nullptr) {
      place.fail(unknown_name_message(
          "parameter of the " + std::string(name_of(kind)) + " \"" + node.model().name + "\"", name,
          names));
    }
    desc::Value value = reader.read(*spec, json);
    if (const auto reason = desc::complaint(*spec, value)) {
      place.fail("\"" + name + "\" " + *reason);
    }
    node.set(name, std::move(value));
  }
}

Mat4 read_transform(const Json& json, const JsonPlace& place, const char* name) {
  const auto fail = [&] {
    place.fail("\"" + std::string(name) + "\" must be a matrix of 4 x 4 finite numbers, not " +
               shown(json));
  };
  if (!json.is_array() || json.size() != 16) fail();
  Mat4 matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const Json& number = json[static_cast<std::size_t>(4 * row + column)];
      if (!number.is_number()) fail();
      matrix[column][row] = number.get<double>();
    }
  }
  if (!is_finite(matrix)) fail();
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
