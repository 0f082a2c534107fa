#include "scene/texture/inputs.h"

#include <filesystem>

namespace ajar {
namespace {

constexpr WarningKind kUnreadable{Effect::Surface, "textures cannot be read, shown as magenta"};

}  // namespace

TextureSlot TextureInputs::slot(std::string_view name) const {
  const desc::Value& value = node().get(name);
  if (const auto* texture = std::get_if<desc::TextureRef>(&value);
      texture != nullptr && texture->id >= static_cast<desc::TextureId>(made_.size())) {
    throw SceneError(description_.where, "a texture refers to one that is not yet defined");
  }
  return texture_slot(value, made_);
}

std::shared_ptr<const TexelImage> TextureInputs::image(std::string_view name) const {
  const std::string& path = node().text(name);
  const CachedImage& cached = images_.at(path);
  if (!cached.image) {
    warnings_.add(
        kUnreadable, description_.where,
        "cannot read image \"" + path + "\" (" + cached.error + "); it is replaced by magenta",
        std::filesystem::path(path).filename().string());
  }
  return cached.image;
}

}  // namespace ajar
