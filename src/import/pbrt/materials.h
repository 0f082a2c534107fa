#pragma once
#include <memory>
#include <string>

#include "import/pbrt/textures.h"

namespace ajar::pbrt {

/// A material as a `Material` or `MakeNamedMaterial` directive describes it; shapes may override
/// its parameters.
struct MaterialChoice {
  desc::MaterialId id = desc::kNone;
  std::string type;
  std::string name;
  std::shared_ptr<const ParameterList> parameters;
};
using MaterialPointer = std::shared_ptr<const MaterialChoice>;

/// The materials of the scene and their names in the current scope.
class MaterialTable {
 public:
  MaterialTable(Context& context, TextureTable& textures)
      : context_(context), textures_(textures) {}

  /// `Material "type" parameters`; "" and "none" are interfaces between media.
  MaterialPointer make(const SourceLocation& where, const std::string& type,
                       std::shared_ptr<const ParameterList> parameters,
                       const std::string& name = "");
  /// `MakeNamedMaterial "name" "string type" … `.
  void make_named(const SourceLocation& where, const std::string& name,
                  std::shared_ptr<const ParameterList> parameters);
  /// For a name that no material has yet, after a warning, pbrt's default.
  MaterialPointer named(const SourceLocation& where, const std::string& name);
  /// Material of a shape: `current` (null: pbrt's default, matte), or a variant of it if the
  /// shape's parameters override some.
  desc::MaterialId for_shape(const SourceLocation& where, MaterialPointer current,
                             const ParameterList& shape);

  /// Names of pbrt-v4 are known to the end of the file.
  void begin_scope() {
    if (!context_.is_v4()) names_.begin_scope();
  }
  void end_scope() {
    if (!context_.is_v4()) names_.end_scope();
  }

 private:
  MaterialPointer default_material(const SourceLocation& where);
  desc::MaterialId build(const SourceLocation& where, const std::string& type,
                         const std::string& name, const TextureParameters& parameters);
  desc::Node make_node(const SourceLocation& where, const std::string& type,
                       const TextureParameters& parameters);
  /// pbrt-v4's mix.
  desc::Node make_mix(const SourceLocation& where, const TextureParameters& parameters);
  /// The part of a mix that a parameter names.
  desc::MaterialId part(const SourceLocation& where, const std::string& type,
                        std::string_view parameter, const TextureParameters& parameters);

  Context& context_;
  TextureTable& textures_;
  ScopedNames<MaterialPointer> names_;
  MaterialPointer default_;
};

}  // namespace ajar::pbrt
