// Textures made of other textures. Source: pbrt-v3, section 10.3.
#include "scene/texture/constant_texture.h"
#include "scene/texture/inputs.h"

namespace ajar {

namespace {

class ProductTexture final : public Texture {
 public:
  explicit ProductTexture(const TextureInputs& in)
      : first_(in.slot("first")), second_(in.slot("second")) {}
  Spectrum eval(const SurfacePoint& at) const override {
    return first_.eval(at) * second_.eval(at);
  }
  float eval_float(const SurfacePoint& at) const override {
    return first_.eval_float(at) * second_.eval_float(at);
  }
  bool is_constant() const { return first_.is_constant() && second_.is_constant(); }

 private:
  TextureSlot first_;
  TextureSlot second_;
};

class MixTexture final : public Texture {
 public:
  explicit MixTexture(const TextureInputs& in)
      : first_(in.slot("first")), second_(in.slot("second")), amount_(in.slot("amount")) {}
  Spectrum eval(const SurfacePoint& at) const override {
    const float t = amount_.eval_float(at);
    return first_.eval(at) * (1.F - t) + second_.eval(at) * t;
  }
  float eval_float(const SurfacePoint& at) const override {
    const float t = amount_.eval_float(at);
    return first_.eval_float(at) * (1.F - t) + second_.eval_float(at) * t;
  }
  bool is_constant() const {
    return first_.is_constant() && second_.is_constant() && amount_.is_constant();
  }

 private:
  TextureSlot first_;
  TextureSlot second_;
  TextureSlot amount_;
};

/// A constant if it is made of constants only.
template <typename Combination>
std::unique_ptr<const Texture> combine(const TextureInputs& in) {
  auto texture = std::make_unique<Combination>(in);
  if (!texture->is_constant()) return texture;
  return std::make_unique<ConstantTexture>(texture->eval(SurfacePoint{}));
}

}  // namespace

TextureModel product_texture() {
  return {{.name = "product",
           .summary = "two textures, multiplied",
           .source = "",
           .parameters = {declare::textured_color("first", "1", "a factor"),
                          declare::textured_color("second", "1", "a factor")}},
          combine<ProductTexture>};
}

TextureModel mix_texture() {
  return {{.name = "mix",
           .summary = "two textures, blended by a third",
           .source = "",
           .parameters = {declare::textured_color("first", "0", "what there is where amount is 0"),
                          declare::textured_color("second", "1", "what there is where it is 1"),
                          declare::textured_number("amount", "0.5", "share of the second", 1.0)}},
          combine<MixTexture>};
}

}  // namespace ajar
