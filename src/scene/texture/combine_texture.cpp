// Constants and textures made of other textures. Source: pbrt-v3, section 10.3.
#include "scene/texture/constant_texture.h"
#include "scene/texture/texture_builders.h"

namespace ajar {

namespace {

class ScaleTexture final : public Texture {
 public:
  ScaleTexture(const TextureSlot& a, const TextureSlot& b) : a_(a), b_(b) {}
  Spectrum eval(const SurfacePoint& at) const override { return a_.eval(at) * b_.eval(at); }
  float eval_float(const SurfacePoint& at) const override {
    return a_.eval_float(at) * b_.eval_float(at);
  }

 private:
  TextureSlot a_;
  TextureSlot b_;
};

class MixTexture final : public Texture {
 public:
  MixTexture(const TextureSlot& a, const TextureSlot& b, const TextureSlot& amount)
      : a_(a), b_(b), amount_(amount) {}
  Spectrum eval(const SurfacePoint& at) const override {
    const float t = amount_.eval_float(at);
    return a_.eval(at) * (1.F - t) + b_.eval(at) * t;
  }
  float eval_float(const SurfacePoint& at) const override {
    const float t = amount_.eval_float(at);
    return a_.eval_float(at) * (1.F - t) + b_.eval_float(at) * t;
  }

 private:
  TextureSlot a_;
  TextureSlot b_;
  TextureSlot amount_;
};

}  // namespace

TextureSlot texture_slot(desc::TextureId id, const TextureList& textures, float fallback) {
  if (id < 0) return TextureSlot(Spectrum(fallback));
  return TextureSlot(textures.at(static_cast<std::size_t>(id)).get());
}

std::unique_ptr<const Texture> make_texture(const desc::ConstantTexture& node) {
  return std::make_unique<ConstantTexture>(Spectrum(node.value.x, node.value.y, node.value.z));
}

std::unique_ptr<const Texture> make_texture(const desc::ScaleTexture& node,
                                            const TextureList& textures) {
  const TextureSlot a = texture_slot(node.a, textures, 1.F);
  const TextureSlot b = texture_slot(node.b, textures, 1.F);
  auto texture = std::make_unique<ScaleTexture>(a, b);
  if (!a.is_constant() || !b.is_constant()) return texture;
  return std::make_unique<ConstantTexture>(texture->eval(SurfacePoint{}));
}

std::unique_ptr<const Texture> make_texture(const desc::MixTexture& node,
                                            const TextureList& textures) {
  const TextureSlot a = texture_slot(node.a, textures, 0.F);
  const TextureSlot b = texture_slot(node.b, textures, 1.F);
  const TextureSlot amount = texture_slot(node.amount, textures, 0.5F);
  auto texture = std::make_unique<MixTexture>(a, b, amount);
  if (!a.is_constant() || !b.is_constant() || !amount.is_constant()) return texture;
  return std::make_unique<ConstantTexture>(texture->eval(SurfacePoint{}));
}

}  // namespace ajar
