#include "import/gltf/materials.h"

#include "import/common/studio.h"
#include "import/gltf/surface_reader.h"

namespace ajar::gltf {

const Surface& Materials::of(const Element& primitive) {
  const std::optional<Element> reference = primitive.find("material");
  if (!reference) {
    if (none_.material == desc::kNone) none_.material = add_neutral_material(context_.scene);
    return none_;
  }
  const Element material = reference->referred(context_.document.root(), "materials");
  const auto made = made_.find(material.pointer());
  if (made != made_.end()) return made->second;
  SurfaceReader reader(context_, images_, material);
  return made_.emplace(material.pointer(), reader.read()).first->second;
}

}  // namespace ajar::gltf
