#include "import/pbrt/writer_names.h"

namespace ajar::pbrt {
namespace {

class UseFinder {
 public:
  explicit UseFinder(const desc::SceneDesc& scene) : scene_(scene), uses_(scene.textures.size()) {}

  std::vector<TextureUse> run() {
    for (const desc::Material& material : scene_.materials) {
      floats(material.bump);
      mark(material.normal_map.texture, {false, true});
      visit(material.node, {false, true});
    }
    for (const desc::Shape& shape : scene_.shapes) visit(shape);
    for (const desc::Object& object : scene_.objects) {
      for (const desc::Shape& shape : object.shapes) visit(shape);
    }
    // Textures refer to earlier ones only: going backwards, a texture's own uses are known.
    for (std::size_t i = uses_.size(); i-- > 0;) visit(scene_.textures[i].node, uses_[i]);
    return std::move(uses_);
  }

 private:
  template <typename... Ids>
  void floats(Ids... ids) {
    (mark(ids, {true, false}), ...);
  }
  void mark(desc::TextureId id, TextureUse use) {
    if (id < 0) return;
    TextureUse& known = uses_.at(static_cast<std::size_t>(id));
    known.as_float |= use.as_float;
    known.as_spectrum |= use.as_spectrum;
  }

  void visit(const desc::Shape& shape) {
    floats(shape.alpha, shape.shadow_alpha);
    visit(shape.node, {false, true});
    if (shape.emission) visit(shape.emission->node, {false, true});
  }
  /// `use_of_colors`: use of the textures for colours.
  void visit(const desc::Node& node, TextureUse use_of_colors) {
    for (std::size_t i = 0; i < node.values().size(); ++i) {
      const auto* reference = std::get_if<desc::TextureRef>(&node.values()[i]);
      if (reference == nullptr) continue;
      const bool is_float = node.model().parameters[i].type == ParameterType::Float;
      mark(reference->id, is_float ? TextureUse{true, false} : use_of_colors);
    }
  }

  const desc::SceneDesc& scene_;
  std::vector<TextureUse> uses_;
};

}  // namespace

std::vector<TextureUse> texture_uses(const desc::SceneDesc& scene) {
  return UseFinder(scene).run();
}

}  // namespace ajar::pbrt
