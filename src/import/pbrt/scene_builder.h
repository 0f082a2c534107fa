#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/warnings.h"
#include "import/mesh/mesh_loader.h"
#include "import/pbrt/context.h"
#include "import/pbrt/materials.h"
#include "import/pbrt/options.h"
#include "import/pbrt/shapes.h"
#include "import/pbrt/textures.h"
#include "import/pbrt/transform_state.h"

namespace ajar::pbrt {

/// Turns directives, one call each and in the order of the file, into a scene description:
/// pbrt-v3's graphics state. All calls raise SceneError at `where` for what cannot be used.
class SceneBuilder {
 public:
  SceneBuilder(FileAccess& files, std::string source, Warnings& warnings);

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
  enum class Scope { Attribute, Transform, Object };
  struct GraphicsState {
    MaterialPointer material;
    std::shared_ptr<const desc::Emission> emission;
    std::string inside, outside;
    SourceLocation media_where;
    bool reverse_orientation = false;
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
  desc::MediumId medium_id(const std::string& name) const;
  desc::TextureId alpha(const ParameterList& parameters, std::string_view name);
  void finish_realistic_camera();

  Warnings& warnings_;
  desc::SceneDesc scene_;
  SpectrumReader spectra_;
  Context context_;
  TransformState transforms_;
  TextureTable textures_;
  MaterialTable materials_;
  MeshLoader meshes_;
  Stage stage_ = Stage::Options;
  GraphicsState state_;
  std::vector<OpenScope> scopes_;
  std::map<std::string, desc::MediumId> media_;
  std::map<std::string, desc::ObjectId> objects_;
  desc::ObjectId open_object_ = desc::kNone;
  std::optional<CameraOptions> camera_;
  float film_diagonal_ = 35.F;
};

}  // namespace ajar::pbrt
