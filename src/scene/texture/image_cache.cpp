#include "scene/texture/image_cache.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <type_traits>

#include "core/error.h"
#include "core/parallel_for.h"
#include "imageio/image_input.h"
#include "os/available_memory.h"
#include "scene/named_file.h"

namespace ajar {

namespace {

struct ChannelRange {
  int first = 0;
  int count = 1;
};

/// Nothing for alpha that an image does not have.
std::optional<ChannelRange> kept_channels(const ColorChannels& colors, ImageChannel channel) {
  const bool is_gray = colors.count < 3;
  const ChannelRange color{colors.first, colors.count};
  switch (channel) {
    case ImageChannel::Color:
      return color;
    case ImageChannel::Red:
      return ChannelRange{colors.first};
    case ImageChannel::Green:
      return ChannelRange{colors.first + (is_gray ? 0 : 1)};
    case ImageChannel::Blue:
      return ChannelRange{colors.first + (is_gray ? 0 : 2)};
    case ImageChannel::AlphaOrColor:
      if (colors.alpha < 0) return color;
      break;
    case ImageChannel::VaryingAlphaOrColor:
      if (colors.alpha < 0 || is_gray) return color;
      break;
    case ImageChannel::Alpha:
      break;
  }
  if (colors.alpha < 0) return std::nullopt;
  return ChannelRange{colors.alpha};
}

/// One texel of 1.
TexelImage opaque_image() { return {1, 1, 1, false, {}, std::vector<std::uint8_t>{255}}; }

/// True if each texel is 1.
bool is_opaque(const TexelImage& image) {
  return std::visit(
      []<typename T>(const std::vector<T>& texels) {
        T opaque(1);
        if constexpr (std::is_integral_v<T>) opaque = std::numeric_limits<T>::max();
        return std::all_of(texels.begin(), texels.end(), [&](T v) { return v == opaque; });
      },
      image.texels);
}

}  // namespace

TexelImage read_texel_image(const ImageRequest& request, const desc::EmbeddedFiles& embedded) {
  const NamedFile file(request.path, embedded);
  ImageInput input(file.path(), true);
  const ImageHeader& header = input.header();
  const std::optional<ChannelRange> channels = kept_channels(input.colors(), request.channel);
  if (!channels) return opaque_image();
  TexelImage image;
  image.width = header.width;
  image.height = header.height;
  image.channels = channels->count;
  image.has_other_primaries = image.channels == 3 && header.has_other_primaries;
  image.remark = input.colors().remark;
  const auto read = [&]<typename T>(T) {
    image.texels = input.read_from<T>(channels->first, channels->count);
  };
  switch (header.type) {
    case SampleType::UInt8:
      read(std::uint8_t{});
      break;
    case SampleType::UInt16:
      read(std::uint16_t{});
      break;
    case SampleType::Half:
      read(Imath::half{});
      break;
    case SampleType::Float:
      read(float{});
  }
  if (request.channel == ImageChannel::VaryingAlphaOrColor &&
      channels->first == input.colors().alpha && is_opaque(image)) {
    return read_texel_image({request.path, ImageChannel::Color}, embedded);
  }
  return image;
}

ImageSize image_size(const ImageRequest& request, const desc::EmbeddedFiles& embedded) {
  try {
    const NamedFile file(request.path, embedded);
    const ImageInput input(file.path());
    const ImageHeader& header = input.header();
    const std::optional<ChannelRange> kept = kept_channels(input.colors(), request.channel);
    if (!kept) return {1, 1};
    const std::uint64_t channel_bytes = size_of(header.type);
    if (!memory_shortage(input.bytes(kept->count, channel_bytes)).empty()) return {};
    const bool may_be_color = request.channel == ImageChannel::VaryingAlphaOrColor;
    const auto channels = static_cast<std::uint64_t>(may_be_color ? 3 : kept->count);
    return {header.pixels(), header.pixels() * channels * channel_bytes};
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
