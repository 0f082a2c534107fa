#pragma once
#include <map>
#include <vector>

#include "import/mitsuba/textures.h"

namespace ajar::mitsuba {

/// Translation of a BSDF of Mitsuba for a shape of ours.
struct Surface {
  desc::MaterialId material = desc::kNone;
  desc::TextureId alpha = desc::kNone;  ///< where it is 0, there is no surface
  /// Black from behind in Mitsuba; ours are the same from both sides.
  bool is_one_sided = false;
};

/// The materials of the scene, each made once however often it is referred to.
class MaterialTable {
 public:
  MaterialTable(Context& context, TextureTable& textures)
      : context_(context), textures_(textures) {}

  /// Makes the surface of a `<bsdf>`. Raises SceneError for one that refers to itself.
  Surface make(const Element& bsdf);
  /// A diffuse one, for shapes without any.
  Surface diffuse(float reflectance);
  /// Nothing but a boundary between media.
  Surface interface();

  desc::MaterialId add(const Element& element, desc::Node node);
  /// Reflects nothing.
  desc::MaterialId black();
  const desc::Material& get(desc::MaterialId id) const {
    return context_.scene.materials[static_cast<std::size_t>(id)];
  }
  TextureTable& textures() { return textures_; }

 private:
  desc::MaterialId add_shared(desc::MaterialId& id, desc::Node node);
  /// Raises SceneError for mixes that are too deep within each other: by references they could be
  /// of any depth, which all that follows parts of mixes has to pass.
  void check_depth(desc::MaterialId id, const SourceLocation& where);

  Context& context_;
  TextureTable& textures_;
  std::map<const Element*, Surface> made_;
  std::vector<int> depths_;  ///< depths of mixes within each material of the scene
  std::map<float, desc::MaterialId> diffuse_;
  desc::MaterialId interface_ = desc::kNone;
};

}  // namespace ajar::mitsuba
