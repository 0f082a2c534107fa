#pragma once
#include <map>
#include <set>
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

  /// Of `<shape>` in the scene.
  void add(const Element& shape);

 private:
  void add_to(const Element& shape, std::vector<desc::Shape>& shapes, bool is_in_group, int depth);
  void add_instance(Arguments& arguments);
  desc::ObjectId object_of(const Element& group);
  void set_material(Arguments& arguments, desc::Shape& shape, bool is_closed);
  void set_emission(Arguments& arguments, desc::Shape& shape, bool is_in_group);
  void warn_of_back(const Element& bsdf);

  Context& context_;
  TextureTable& textures_;
  MaterialTable& materials_;
  MediumTable& media_;
  MeshLoader& meshes_;
  std::map<const Element*, desc::ObjectId> objects_;
  std::set<const Element*> warned_of_back_;
};

}  // namespace ajar::mitsuba
