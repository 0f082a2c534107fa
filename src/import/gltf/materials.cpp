#include "import/gltf/materials.h"

#include <algorithm>

#include "import/common/studio.h"
#include "import/gltf/surface_reader.h"

namespace ajar::gltf {

std::optional<Element> Materials::find(const Element& primitive) const {
  const std::optional<Element> reference = primitive.find("material");
  if (!reference) return std::nullopt;
  return reference->referred(context_.document.root(), "materials");
}

bool Materials::has_textures(const Element& primitive) const {
  const std::optional<Element> material = find(primitive);
  if (!material) return false;
  const std::vector<std::string> names = material->names();
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    // Occlusion textures are not read.
    if (name == "occlusionTexture" || name == "extras") return false;
    return name.ends_with("Texture") || material->at(name).mentions("Texture");
  });
}

const Surface& Materials::of(const Element& primitive, const VertexColors* colors) {
  const std::optional<Element> material = find(primitive);
  const std::pair key(material ? material->pointer() : "", colors == nullptr ? "" : colors->name);
  const auto made = made_.find(key);
  if (made != made_.end()) return made->second;
  return made_.emplace(key, make(material, colors)).first->second;
}

Surface Materials::make(const std::optional<Element>& material, const VertexColors* colors) {
  // Without one all has its defaults, which are those of a white metal.
  static const Json kDefaults = Json::object();
  const Element defaults(kDefaults, context_.document.origin, "/materials");
  return SurfaceReader(context_, images_, material ? *material : defaults, colors).read();
}

}  // namespace ajar::gltf
