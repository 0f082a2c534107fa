#include "import/gltf/images.h"

#include "core/error.h"
#include "import/gltf/uri.h"

namespace ajar::gltf {
namespace {

constexpr WarningKind kNoImage{Effect::Surface, "images cannot be found: left out"};

std::string suffix_of(const std::string& media_type) {
  if (media_type == "image/png") return ".png";
  if (media_type == "image/jpeg") return ".jpg";
  if (media_type == "image/webp") return ".webp";
  return "";
}

}  // namespace

std::optional<std::string> Images::name_of(const Element& image) {
  const auto [place, is_new] = known_.try_emplace(image.pointer());
  if (is_new) place->second = find(image);
  return place->second;
}

std::optional<std::string> Images::find(const Element& image) {
  const std::string media_type = image.value_or<std::string>("mimeType", "");
  if (const std::optional<BufferView> view = buffers_.find_view(image, "bufferView")) {
    return embed(image, std::string(view->bytes), media_type);
  }
  const Element uri = image.at("uri");
  try {
    UriTarget target = target_of(uri);
    if (!target.data) return context_.files.resolve_inside(target.file, uri.where());
    return embed(image, std::move(*target.data),
                 media_type.empty() ? target.media_type : media_type);
  } catch (const IoError& error) {
    context_.warnings.add(kNoImage, uri.where(),
                          std::string("this image is left out: ") + error.what());
    return std::nullopt;
  }
}

std::string Images::embed(const Element& image, std::string bytes, const std::string& media_type) {
  std::string name = context_.path + image.pointer() + suffix_of(media_type);
  context_.scene.embedded_files[name] = std::make_shared<const std::string>(std::move(bytes));
  return name;
}

}  // namespace ajar::gltf
