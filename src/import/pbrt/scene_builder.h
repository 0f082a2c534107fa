#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/warnings.h"
#include "import/mesh/mesh_loader.h"
#include "import/pbrt/color_space.h"
#include "import/pbrt/context.h"
#include "import/pbrt/film.h"
#include "import/pbrt/lights.h"
#include "import/pbrt/materials.h"
#include "import/pbrt/options.h"
#include "import/pbrt/shapes.h"
#include "import/pbrt/textures.h"
#include "import/pbrt/transform_state.h"

namespace ajar::pbrt {

/// Turns directives, one call each and in the order of the file, into a scene description: pbrt's
/// graphics state. All calls raise SceneError at `where` for invalid ones.
class SceneBuilder {
 public:
  SceneBuilder(FileAccess& files, std::string source, const DialectChoice& choice,
               Warnings& warnings);

  const Context& context() const { return context_; }

  TransformState& transforms() { return transforms_; }

  void camera(const SourceLocation& where, const std::string& type,
              const ParameterList& parameters);
  void film(const SourceLocation& where, const std::string& type, const ParameterList& parameters);
  void pixel_filter(const SourceLocation& where, const std::string& type,
                    const ParameterList& parameters);
  void sampler(const SourceLocation& where, const std::string& type,
               const ParameterList& parameters);
  void integrator(const SourceLocation& where, const std::string& type,
                  const ParameterList& parameters);

  // `Attribute` (pbrt-v4 alone): parameters that later directives for `target` have unless they say
  // otherwise.
  void attribute(const SourceLocation& where, const std::string& target,
                 const ParameterList& parameters);
  /// Current attributes; `target` is one of `attribute_targets`.
  std::span<const AttributePointer> attributes(std::string_view target) const;
  static const std::vector<std::string>& attribute_targets();
  void color_space(const SourceLocation& where, const std::string& name);
  /// Colour space of colours written now; null in pbrt-v3, which has none.
  const ColorSpace* color_space() const { return state_.color_space; }
  /// `place`: that of the name; `is_on`: unless the value is "false".
  void option(const SourceLocation& where, const SourceLocation& place, const std::string& name,
              bool is_on);
  /// Scope of an imported file's changes.
  void import_begin(const SourceLocation& where);
  void import_end();

  void world_begin(const SourceLocation& where);
  void world_end(const SourceLocation& where);
  bool world_ended() const { return stage_ == Stage::Done; }

  void attribute_begin(const SourceLocation& where);
  void attribute_end(const SourceLocation& where);
  void transform_begin(const SourceLocation& where);
  void transform_end(const SourceLocation& where);
  void object_begin(const SourceLocation& where, const std::string& name);
  void object_end(const SourceLocation& where);
  void object_instance(const SourceLocation& where, const std::string& name);
  void reverse_orientation(const SourceLocation& where);

  void texture(const SourceLocation& where, const std::string& name,
               const std::string& texture_class, const std::string& type,
               const ParameterList& parameters);
  void material(const SourceLocation& where, const std::string& type,
                std::shared_ptr<const ParameterList> parameters);
  void make_named_material(const SourceLocation& where, const std::string& name,
                           std::shared_ptr<const ParameterList> parameters);
  void named_material(const SourceLocation& where, const std::string& name);
  void make_named_medium(const SourceLocation& where, const std::string& name,
                         const ParameterList& parameters);
  void medium_interface(const SourceLocation& where, const std::string& inside,
                        const std::string& outside);
  void light_source(const SourceLocation& where, const std::string& type,
                    const ParameterList& parameters);
  void area_light_source(const SourceLocation& where, const std::string& type,
                         const ParameterList& parameters);
  void shape(const SourceLocation& where, const std::string& type, const ParameterList& parameters);

  /// Reads the mesh files and gives the scene away. `end` is the end of the file.
  desc::SceneDesc finish(const SourceLocation& end);

 private:
  enum class Stage { Options, World, Done };
  enum class Scope { Attribute, Transform, Object, Import };
  using Attributes = std::map<std::string, std::shared_ptr<const std::vector<AttributePointer>>>;
  struct GraphicsState {
    MaterialPointer material;
    std::shared_ptr<const AreaEmission> emission;
    std::string inside, outside;
    SourceLocation media_where;
    bool reverse_orientation = false;
    const ColorSpace* color_space = nullptr;
    Attributes attributes;
  };
  /// A shape whose emission is scaled when its mesh is known.
  struct Powered {
    std::size_t shape;
    float power;
    std::size_t triangles_per_primitive;
  };
  struct OpenScope {
    Scope kind;
    SourceLocation where;
    std::optional<GraphicsState> saved;
  };

  bool in_options(const SourceLocation& where, const std::string& directive);
  void require_world(const SourceLocation& where, const char* directive) const;
  void open(Scope kind, const SourceLocation& where);
  void close(Scope kind, const SourceLocation& where);
  void restore_innermost();
  /// Ends the blocks, each with a warning, that are open in the innermost one of the kind `until`;
  /// all, if that is nothing.
  void close_open_blocks(std::optional<Scope> until);
  /// None for "", and, after a warning, for a name that no medium has yet.
  desc::MediumId medium_id(const std::string& name);
  desc::TextureId alpha(const ParameterList& parameters, std::string_view name);
  void emit(const SourceLocation& where, desc::Shape& shape);
  /// pbrt-v4: of a shape with an "alpha" that is not 0 or 1 everywhere, the rest lets light pass.
  void make_partly_clear(const ParameterList& parameters, desc::Shape& shape);
  /// pbrt-v4 has lamps that only light: ours are seen, and let light pass.
  void show_hidden_lamp(desc::Shape& shape);
  void finish_realistic_camera();

  const DialectChoice choice_;
  Warnings& warnings_;
  desc::SceneDesc scene_;
  SpectrumReader spectra_;
  CloudGrids clouds_;
  Context context_;
  TransformState transforms_;
  TextureTable textures_;
  MaterialTable materials_;
  MeshLoader meshes_;
  Stage stage_ = Stage::Options;
  GraphicsState state_;
  std::vector<OpenScope> scopes_;
  std::map<std::string, desc::MediumId> media_;
  std::set<std::string> unknown_media_;  ///< unknown media that were warned of
  std::vector<AttributePointer> all_attributes_;
  std::map<std::string, desc::ObjectId> objects_;
  desc::ObjectId open_object_ = desc::kNone;
  std::optional<CameraOptions> camera_;
  std::optional<std::pair<std::string, SourceLocation>> integrator_;  ///< its type
  std::string camera_medium_;  ///< pbrt-v4: outside, where the camera is made
  std::vector<Powered> powered_;
  /// By the material, and the texture or the number of their opacity.
  std::map<std::tuple<desc::MaterialId, desc::TextureId, float>, desc::MaterialId> partly_clear_;
  float film_diagonal_ = 35.F;
};

}  // namespace ajar::pbrt
