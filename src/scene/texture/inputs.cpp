#include "scene/texture/inputs.h"

#include <filesystem>

namespace ajar {
namespace {

constexpr WarningKind kUnreadable{Effect::Surface, "textures cannot be read, shown as magenta"};
constexpr WarningKind kOtherPrimaries{
    Effect::Surface,
    "textures are files with a red, green and blue of their own, which is not "
    "supported"};

ImageChannel channel_of(const desc::Node& node) {
  if (!node.has("channel")) return ImageChannel::Color;
  const std::string& name = node.text("channel");
  return name == "red"                     ? ImageChannel::Red
         : name == "green"                 ? ImageChannel::Green
         : name == "blue"                  ? ImageChannel::Blue
         : name == "alpha"                 ? ImageChannel::Alpha
         : name == "alpha_or_mean"         ? ImageChannel::AlphaOrColor
         : name == "varying_alpha_or_mean" ? ImageChannel::VaryingAlphaOrColor
                                           : ImageChannel::Color;
}

}  // namespace

std::vector<ImageRequest> image_requests(const desc::Node& node) {
  std::vector<ImageRequest> requests;
  for (std::string& path : node.files()) requests.push_back({std::move(path), channel_of(node)});
  return requests;
}

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
  const CachedImage& cached = images_.at({path, channel_of(node())});
  if (!cached.image) {
    warnings_.add(
        kUnreadable, description_.where,
        "cannot read image \"" + path + "\" (" + cached.error + "); it is replaced by " +
            (channel_of(node()) == ImageChannel::Color && node().text("channel") == "color"
                 ? "magenta"
                 : "1"),
        std::filesystem::path(path).filename().string());
  }
  if (cached.image && cached.image->has_other_primaries) {
    warnings_.add(kOtherPrimaries, description_.where,
                  "image \"" + path +
                      "\" has red, green and blue of its own (\"chromaticities\"): "
                      "they are taken for those of Rec. 709",
                  std::filesystem::path(path).filename().string());
  }
  return cached.image;
}

}  // namespace ajar
