#include "scene/texture/constant_texture.h"

#include "scene/texture/inputs.h"

namespace ajar {

TextureModel constant_texture() {
  return {{.name = "constant",
           .summary = "the same value everywhere",
           .source = "",
           .parameters = {declare::color("value", "1", "the value")}},
          [](const TextureInputs& in) -> std::unique_ptr<const Texture> {
            return std::make_unique<ConstantTexture>(in.color("value"));
          }};
}

}  // namespace ajar
