#include "import/gltf/materials.h"

#include "import/common/studio.h"
#include "import/gltf/surface_reader.h"

namespace ajar::gltf {

std::optional<Element> Materials::find(const Element& primitive) const {
  const std::optional<Element> reference = primitive.find("material");
  if (!reference) return std::nullopt;
  return referred(*reference, context_.document.root, "materials");
}

bool Materials::has_textures(const Element& primitive) const {
  const std::optional<Element> material = find(primitive);
  std::vector<Element> left;
  if (material) left.push_back(*material);
  while (!left.empty()) {
    const Element object = left.back();
    left.pop_back();
    for (const auto& [name, key, member] : object.members()) {
      // Occlusion textures are not read.
      if (name == "occlusionTexture" || name == "extras") continue;
      if (name.ends_with("Texture")) return true;
      if (member.is(Element::Kind::Object)) left.push_back(member);
    }
  }
  return false;
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
  const Element defaults = context_.document.root.without_members();
  return SurfaceReader(context_, images_, material.value_or(defaults), colors).read();
}

}  // namespace ajar::gltf
