#include "import/pbrt/writer_names.h"

namespace ajar::pbrt {
namespace {

class UseFinder {
 public:
  explicit UseFinder(const desc::SceneDesc& scene) : scene_(scene), uses_(scene.textures.size()) {}

  std::vector<TextureUse> run() {
    for (const desc::Material& material : scene_.materials) {
      floats(material.bump);
      visit(material.node);
    }
    for (const desc::Shape& shape : scene_.shapes) visit(shape);
    for (const desc::Object& object : scene_.objects) {
      for (const desc::Shape& shape : object.shapes) visit(shape);
    }
    // Textures refer to earlier ones only: going backwards, a texture's own uses are known.
    for (std::size_t i = uses_.size(); i-- > 0;) pass_on(i);
    return std::move(uses_);
  }

 private:
  template <typename... Ids>
  void floats(Ids... ids) {
    (mark(ids, {true, false}), ...);
  }
  template <typename... Ids>
  void spectra(Ids... ids) {
    (mark(ids, {false, true}), ...);
  }
  void mark(desc::TextureId id, TextureUse use) {
    if (id < 0) return;
    TextureUse& known = uses_.at(static_cast<std::size_t>(id));
    known.as_float |= use.as_float;
    known.as_spectrum |= use.as_spectrum;
  }

  void visit(const desc::Shape& shape) {
    floats(shape.alpha, shape.shadow_alpha);
    if (shape.light) spectra(shape.light->texture);
  }
  void visit(const desc::Node& node) {
    for (std::size_t i = 0; i < node.values().size(); ++i) {
      const auto* reference = std::get_if<desc::TextureRef>(&node.values()[i]);
      if (reference == nullptr) continue;
      const bool is_float = node.model().parameters[i].type == ParameterType::Float;
      mark(reference->id, {is_float, !is_float});
    }
  }

  void pass_on(std::size_t i) {
    const TextureUse use = uses_[i];
    const auto& node = scene_.textures[i].node;
    if (const auto* s = std::get_if<desc::ScaleTexture>(&node)) {
      mark(s->a, use);
      mark(s->b, use);
    } else if (const auto* m = std::get_if<desc::MixTexture>(&node)) {
      mark(m->a, use);
      mark(m->b, use);
      floats(m->amount);
    } else if (const auto* c = std::get_if<desc::CheckerboardTexture>(&node)) {
      mark(c->a, use);
      mark(c->b, use);
    } else if (const auto* d = std::get_if<desc::DotsTexture>(&node)) {
      mark(d->inside, use);
      mark(d->outside, use);
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
