#pragma once
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/parameters.h"
#include "core/vector.h"

/// Neutral description of a scene, in words that belong to no file format: a node is of a model,
/// which declares its parameters. Code that handles nodes without rendering them (import, hash,
/// writer, `ajar info`, `ajar list`) loops over the parameters of their models and knows none of
/// them.
namespace ajar::desc {

/// Linear Rec. 709.
using Rgb = Imath::V3f;
/// Index into the vector of the same name in `SceneDesc`; -1 means none.
using TextureId = int;
using MaterialId = int;
using MediumId = int;
using ObjectId = int;
inline constexpr int kNone = -1;

struct TextureRef {
  TextureId id = kNone;
  bool operator==(const TextureRef&) const = default;
};
struct MaterialRef {
  MaterialId id = kNone;
  bool operator==(const MaterialRef&) const = default;
};
/// Shared, so that a value stays small.
using TransformPointer = std::shared_ptr<const Mat4>;
struct Mesh;
struct Curves;
/// Data of shapes (`scene/desc/shape_data.h`). Values are equal if they are the same object. Null
/// by default.
using MeshPointer = std::shared_ptr<const Mesh>;
using CurvesPointer = std::shared_ptr<const Curves>;

/// The value of a parameter: by its type bool, int, float, string (Text, Choice, File), Vec3
/// (Color, Vector), TransformPointer, MaterialRef, MeshPointer or CurvesPointer; TextureRef in
/// place of a textured float or colour; nothing, if the parameter has no default and was not given.
using Value = std::variant<std::monostate, bool, int, float, Vec3, std::string, TextureRef,
                           MaterialRef, TransformPointer, MeshPointer, CurvesPointer>;

/// A kind of material, texture, … that scenes can have. There is one object per model, which lives
/// as long as the program (`scene/desc/models.h`).
struct Model {
  std::string name;
  std::string summary;  ///< one line
  std::string source;   ///< paper or book; may be empty
  std::vector<ParameterSpec> parameters;
};

/// The value that `spec.default_value` spells. Raises std::logic_error if it spells none.
Value default_value(const ParameterSpec& spec);
/// Why a parameter cannot have `value`, as in "must be between 0 and 64, not 65"; nothing if it
/// can. Raises std::logic_error if the value is not of the parameter's type.
std::optional<std::string> complaint(const ParameterSpec& spec, const Value& value);

/// A model with a value for each of its parameters.
class Node {
 public:
  using Given = std::initializer_list<std::pair<std::string_view, Value>>;

  /// A node without a model: a scene with such a node cannot be built.
  Node() = default;
  /// All parameters but those given have their defaults. Raises as `set` does.
  explicit Node(const Model& model, Given given = {});

  bool has_model() const { return model_ != nullptr; }
  const Model& model() const { return *model_; }
  bool is(std::string_view model_name) const { return has_model() && model_->name == model_name; }

  /// Raises SceneError, without a location, for values out of range, and std::logic_error for names
  /// that the model does not have and for values of another type.
  void set(std::string_view name, Value value);

  /// Values of `model().parameters`, in their order.
  std::span<const Value> values() const { return values_; }
  bool has(std::string_view name) const { return find(name) != nullptr; }
  /// Raises std::logic_error for names that the model does not have.
  const Value& get(std::string_view name) const;
  /// The value by type; raises as `get` does and std::bad_variant_access.
  bool flag(std::string_view name) const { return std::get<bool>(get(name)); }
  int integer(std::string_view name) const { return std::get<int>(get(name)); }
  float number(std::string_view name) const { return std::get<float>(get(name)); }
  const Vec3& vector(std::string_view name) const { return std::get<Vec3>(get(name)); }
  const Rgb& color(std::string_view name) const { return std::get<Vec3>(get(name)); }
  const std::string& text(std::string_view name) const { return std::get<std::string>(get(name)); }
  const Mat4& transform(std::string_view name) const {
    return *std::get<TransformPointer>(get(name));
  }
  const MeshPointer& mesh(std::string_view name) const { return std::get<MeshPointer>(get(name)); }
  const CurvesPointer& curves(std::string_view name) const {
    return std::get<CurvesPointer>(get(name));
  }
  TextureId texture(std::string_view name) const { return std::get<TextureRef>(get(name)).id; }
  MaterialId material(std::string_view name) const { return std::get<MaterialRef>(get(name)).id; }

  /// False for parameters that have no effect because of the value of another.
  bool matters(const ParameterSpec& spec) const;
  /// All its values of the type File.
  std::vector<std::string> files() const;

  bool operator==(const Node&) const = default;

 private:
  /// The declaration of a parameter; null for names that the model does not have.
  const ParameterSpec* find(std::string_view name) const;
  std::size_t position(std::string_view name) const;

  const Model* model_ = nullptr;
  std::vector<Value> values_;
};

}  // namespace ajar::desc
