#include "scene/texture/inputs.h"

namespace ajar {
namespace {

class ThresholdTexture final : public Texture {
 public:
  explicit ThresholdTexture(const TextureInputs& in)
      : value_(in.slot("value")), edge_(in.node().number("edge")) {}
  Spectrum eval(const SurfacePoint& at) const override { return Spectrum(eval_float(at)); }
  float eval_float(const SurfacePoint& at) const override {
    return value_.eval_float(at) >= edge_ ? 1.F : 0.F;
  }

 private:
  TextureSlot value_;
  float edge_;
};

}  // namespace

TextureModel threshold_texture() {
  return {{.name = "threshold",
           .summary = "1 where a texture is large enough, else 0",
           .source = "",
           .parameters = {declare::textured_number("value", "1", "what is compared"),
                          declare::number("edge", "0.5", "the least value that gives 1")}},
          [](const TextureInputs& in) -> std::unique_ptr<const Texture> {
            return std::make_unique<ThresholdTexture>(in);
          }};
}

}  // namespace ajar
