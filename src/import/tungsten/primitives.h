#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "import/tungsten/bsdfs.h"
#include "import/tungsten/geometry.h"
#include "import/tungsten/lights.h"
#include "import/tungsten/media.h"
#include "import/tungsten/mesh_files.h"

namespace ajar::tungsten {

/// True if primitives have such a "type".
bool is_primitive_type(std::string_view name);

/// Reads the primitives of a scene: its shapes and lights.
class PrimitiveReader {
 public:
  PrimitiveReader(Context& context, TextureReader& textures, BsdfTable& bsdfs, MediumTable& media)
      : context_(context), textures_(textures), bsdfs_(bsdfs), media_(media), meshes_(context) {}

  /// Reads the list "primitives".
  void read_all(const LocatedJson& list);

  /// True if Tungsten would find any light in the list, one that is left out here, too.
  bool has_light() const { return has_light_; }

  /// Where the named primitives are.
  const PrimitivePlaces& places() const { return places_; }

 private:
  /// Geometry of a primitive, without what surrounds it.
  std::vector<Part> parts_of(const ObjectReader& object, const std::string& type,
                             const Mat4& transform, int bsdf_count);
  std::vector<Part> mesh_parts(const ObjectReader& object, const Mat4& transform, int bsdf_count);
  std::vector<Part> curve_parts(const ObjectReader& object, const Mat4& transform);
  std::vector<Surface> surfaces_of(const ObjectReader& object);
  std::optional<desc::Emission> emission_of(const ObjectReader& object, double area);
  void warn_of_lids(const ObjectReader& object, const Surface& surface,
                    const std::optional<desc::Emission>& emission);
  void set_media(const ObjectReader& object, const Surface& surface, desc::Shape& shape);

  /// Adds shapes to `shapes`; lights only at the top level, where `shapes` are the scene's.
  void read(const LocatedJson& json, std::vector<desc::Shape>& shapes);
  void read_instances(const ObjectReader& object, const Mat4& transform);
  desc::ObjectId object_of(const LocatedJson& master);

  Context& context_;
  TextureReader& textures_;
  BsdfTable& bsdfs_;
  MediumTable& media_;
  MeshFiles meshes_;
  PrimitivePlaces places_;
  bool has_light_ = false;
  std::map<std::string, LocatedJson, std::less<>> named_;
};

}  // namespace ajar::tungsten
