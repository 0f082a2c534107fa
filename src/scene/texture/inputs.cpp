#include "scene/texture/inputs.h"

#include <filesystem>

namespace ajar {
namespace {

constexpr WarningKind kUnreadable{Effect::Surface, "textures cannot be read, shown as magenta"};
constexpr WarningKind kUnreadableNumbers{
    Effect::Surface, "textures of numbers cannot be read: 1 stands in for them"};
constexpr WarningKind kOtherPrimaries{
    Effect::Surface,
    "textures are files with a red, green and blue of their own, which is not "
    "supported"};

constexpr WarningKind kChannels{Effect::Surface,
                                "textures are files of several layers, of which one is shown"};

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
  const std::string file = std::filesystem::path(path).filename().string();
  const CachedImage& cached = images_.at({path, channel_of(node())});
  const bool is_color = !node().has("channel") || node().text("channel") == "color";
  if (!cached.image) {
    warnings_.add(is_color ? kUnreadable : kUnreadableNumbers, description_.where,
                  "cannot read image \"" + path + "\" (" + cached.error + "); it is replaced by " +
                      (is_color ? "magenta, or left out if it says normals" : "1"),
                  file);
  }
  if (cached.image && !cached.image->remark.empty()) {
    warnings_.add(kChannels, description_.where, "image \"" + path + "\": " + cached.image->remark,
                  file);
  }
  // Vectors and numbers have no primaries.
  const bool is_light = is_color && (!node().has("decode_srgb") || node().flag("decode_srgb"));
  if (cached.image && cached.image->has_other_primaries && is_light) {
    warnings_.add(kOtherPrimaries, description_.where,
                  "image \"" + path +
                      "\" has red, green and blue of its own (\"chromaticities\"): they are taken "
                      "for those of Rec. 709",
                  file);
  }
  return cached.image;
}

}  // namespace ajar
