#include "scene/texture/texture.h"

namespace ajar {

TextureSlot texture_slot(const desc::Value& value, const TextureList& textures) {
  if (const float* number = std::get_if<float>(&value)) return TextureSlot(Spectrum(*number));
  if (const Vec3* color = std::get_if<Vec3>(&value)) return TextureSlot(rgb_spectrum(*color));
  const desc::TextureId id = std::get<desc::TextureRef>(value).id;
  return TextureSlot(textures.at(static_cast<std::size_t>(id)).get());
}

}  // namespace ajar
