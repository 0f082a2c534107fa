#pragma once
#include <functional>

#include "import/common/name_table.h"
#include "import/pbrt/textures.h"
#include "scene/desc/models.h"

namespace ajar::pbrt {

/// Our model that a directive calls `type`: by `table`, or by its own name if pbrt has none for it.
/// Null if there is none.
const desc::Model* model_of_type(desc::ModelKind kind, std::span<const ModelName> table,
                                 std::string_view type);

/// Our model that is meant by one of pbrt's (`kOwnModel`); null if `own` is not given. Raises
/// SceneError if there is none of this name.
const desc::Model* own_model(const Context& context, const SourceLocation& where,
                             desc::ModelKind kind, const std::optional<std::string>& own);

/// All names for directives: those of `table`, and ours that pbrt does not have.
std::vector<std::string> types_of(desc::ModelKind kind, std::span<const ModelName> table);

/// Makes nodes of the parameters of directives. Places come from the current transform, meshes and
/// curves from several parameters: those of ours that are of these types keep their defaults.
class NodeReader {
 public:
  /// Finds the material that a parameter of this name refers to.
  using FindMaterial = std::function<desc::MaterialId(std::string_view parameter)>;

  /// `where` is the directive.
  NodeReader(const SourceLocation& where, const TextureParameters& parameters)
      : where_(where),
        parameters_(parameters),
        has_own_words_(!parameters.context().is_v4() && parameters.has_own_words()) {}

  /// For models that refer to materials.
  NodeReader& with_materials(FindMaterial find_material) {
    find_material_ = std::move(find_material);
    return *this;
  }
  /// For textures of numbers: colours are written as such.
  NodeReader& with_numbers_for_colors(bool numbers) {
    numbers_for_colors_ = numbers;
    return *this;
  }

  /// A node of `model`, which `names`, if any, translates. Raises SceneError for values that the
  /// model does not allow.
  desc::Node read(const desc::Model& model, const ModelName* names) const;

 private:
  desc::Value value(const ParameterSpec& spec, const ParameterName& name) const;
  /// Raises SceneError if it is not.
  desc::Value allowed(const ParameterSpec& spec, std::string_view name,
                      const desc::Value& given) const;
  std::optional<desc::Value> find(const ParameterSpec& spec, std::string_view name) const;
  std::optional<desc::Value> find_color(const ParameterSpec& spec, std::string_view name) const;
  std::optional<desc::Value> find_file(std::string_view name) const;
  std::string choice(const ParameterSpec& spec, std::string_view name,
                     const std::string& given) const;

  const SourceLocation& where_;
  const TextureParameters& parameters_;
  bool has_own_words_;
  FindMaterial find_material_;
  bool numbers_for_colors_ = false;
};

}  // namespace ajar::pbrt
