#pragma once
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "import/mesh/mesh_loader.h"
#include "import/mitsuba/materials.h"
#include "import/mitsuba/media.h"

namespace ajar::mitsuba {

/// Adds shapes, groups of shapes and their instances to the scene.
class ShapeBuilder {
 public:
  ShapeBuilder(Context& context, TextureTable& textures, MaterialTable& materials,
               MediumTable& media, MeshLoader& meshes)
      : context_(context),
        textures_(textures),
        materials_(materials),
        media_(media),
        meshes_(meshes) {}

  /// Adds a `<shape>` of the scene.
  void add(const Element& shape);

 private:
  /// Makes a single shape; nothing, after a warning, if there is none to see.
  std::optional<desc::Shape> make(const Element& shape, bool is_in_group);
  /// The shapes in a merge or a group.
  void add_parts(const Element& whole, std::vector<desc::Shape>& shapes, bool is_in_group);
  void add_instance(const Element& instance);
  desc::ObjectId object_of(const Element& group);
  void set_material(Arguments& arguments, desc::Shape& shape, bool is_closed);
  void set_emission(Arguments& arguments, desc::Shape& shape, bool is_in_group);
  void warn_of_stretched(const Element& sphere, const Mat4& to_world);
  void warn_of_back(const Element& bsdf, desc::MaterialId material);

  Context& context_;
  TextureTable& textures_;
  MaterialTable& materials_;
  MediumTable& media_;
  MeshLoader& meshes_;
  std::map<const Element*, desc::ObjectId> objects_;
  /// Shapes of merges and groups, which refer to one more than once; with and without emission.
  std::map<std::pair<const Element*, bool>, std::optional<desc::Shape>> parts_;
  std::size_t part_count_ = 0;  ///< each as often as it is referred to
  std::set<const Element*> warned_of_back_;
};

}  // namespace ajar::mitsuba
