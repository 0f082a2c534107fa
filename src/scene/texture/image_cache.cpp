#include "scene/texture/image_cache.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "core/available_memory.h"
#include "core/error.h"
#include "core/image_input.h"
#include "core/memory_file.h"
#include "core/parallel_for.h"

namespace ajar {

namespace {

/// The file that a request names, wherever it is.
class ImageFile {
 public:
  ImageFile(const std::string& name, const desc::EmbeddedFiles& embedded) : path_(name) {
    const auto held = embedded.find(name);
    if (held == embedded.end()) return;
    memory_.emplace(*held->second);
    path_ = memory_->path();
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::optional<MemoryFile> memory_;
};

struct ChannelRange {
  int first = 0;
  int count = 1;
};

/// Nothing for alpha that an image does not have.
std::optional<ChannelRange> kept_channels(const OIIO::ImageSpec& spec, ImageChannel channel) {
  const bool is_gray = spec.nchannels < 3;
  switch (channel) {
    case ImageChannel::Color:
      return ChannelRange{0, is_gray ? 1 : 3};
    case ImageChannel::Red:
      return ChannelRange{0};
    case ImageChannel::Green:
      return ChannelRange{is_gray ? 0 : 1};
    case ImageChannel::Blue:
      return ChannelRange{is_gray ? 0 : 2};
    case ImageChannel::Alpha:
      break;
  }
  if (spec.alpha_channel < 0) return std::nullopt;
  return ChannelRange{spec.alpha_channel};
}

/// One texel of 1.
TexelImage opaque_image() { return {1, 1, 1, std::vector<std::uint8_t>{255}}; }

}  // namespace

TexelImage read_texel_image(const ImageRequest& request, const desc::EmbeddedFiles& embedded) {
  const ImageFile file(request.path, embedded);
  ImageInput input(file.path(), true);
  const OIIO::ImageSpec& spec = input.spec();
  const std::optional<ChannelRange> channels = kept_channels(spec, request.channel);
  if (!channels) return opaque_image();
  TexelImage image;
  image.width = spec.width;
  image.height = spec.height;
  image.channels = channels->count;
  const auto read = [&]<typename T>(T) {
    image.texels = input.read_from<T>(channels->first, channels->count);
  };
  switch (spec.format.basetype) {
    case OIIO::TypeDesc::UINT8:
      read(std::uint8_t{});
      break;
    case OIIO::TypeDesc::UINT16:
      read(std::uint16_t{});
      break;
    case OIIO::TypeDesc::HALF:
      read(Imath::half{});
      break;
    default:
      read(float{});
  }
  return image;
}

ImageSize image_size(const ImageRequest& request, const desc::EmbeddedFiles& embedded) {
  try {
    const ImageFile file(request.path, embedded);
    const ImageInput input(file.path());
    const OIIO::ImageSpec& spec = input.spec();
    const std::optional<ChannelRange> kept = kept_channels(spec, request.channel);
    if (!kept) return {1, 1};
    constexpr std::array<unsigned char, 3> kSmallTypes = {
        OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::HALF};
    const bool is_small_type = std::find(kSmallTypes.begin(), kSmallTypes.end(),
                                         spec.format.basetype) != kSmallTypes.end();
    const std::uint64_t channel_bytes = is_small_type ? spec.format.size() : sizeof(float);
    if (!memory_shortage(input.bytes(kept->count, channel_bytes)).empty()) return {};
    const auto channels = static_cast<std::uint64_t>(kept->count);
    return {input.pixels(), input.pixels() * channels * channel_bytes};
  } catch (const IoError&) {
    return {};
  }
}

ImageMap read_images(std::span<const ImageRequest> requests, const desc::EmbeddedFiles& embedded) {
  const std::set<ImageRequest> unique(requests.begin(), requests.end());
  const std::vector<ImageRequest> todo(unique.begin(), unique.end());
  std::vector<CachedImage> images(todo.size());
  parallel_for(todo.size(), [&](std::size_t i) {
    try {
      images[i].image = std::make_shared<const TexelImage>(read_texel_image(todo[i], embedded));
    } catch (const std::exception& error) {
      images[i].error = error.what();
    }
  });
  ImageMap result;
  for (std::size_t i = 0; i < todo.size(); ++i) result.emplace(todo[i], std::move(images[i]));
  return result;
}

}  // namespace ajar
