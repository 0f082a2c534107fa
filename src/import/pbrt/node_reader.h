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

/// Makes nodes of the parameters of directives.
class NodeReader {
 public:
  /// Finds the material that a parameter of this name refers to.
  using FindMaterial = std::function<desc::MaterialId(std::string_view parameter)>;

  /// `where` is the directive.
  NodeReader(const SourceLocation& where, const TextureParameters& parameters,
             FindMaterial find_material)
      : where_(where), parameters_(parameters), find_material_(std::move(find_material)) {}

  /// A node of `model`, which `names`, if any, translates. Raises SceneError for values that the
  /// model does not allow.
  desc::Node read(const desc::Model& model, const ModelName* names) const;

 private:
  desc::Value value(const ParameterSpec& spec, const ParameterName& name) const;
  std::optional<desc::Value> find(const ParameterSpec& spec, std::string_view name) const;
  std::string choice(const ParameterSpec& spec, std::string_view name,
                     const std::string& given) const;

  const SourceLocation& where_;
  const TextureParameters& parameters_;
  FindMaterial find_material_;
};

}  // namespace ajar::pbrt
