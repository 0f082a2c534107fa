#include "scene/texture/image_cache.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/error.h"
#include "core/parallel_for.h"

namespace ajar {

namespace {

/// A file that claims more texels than this is damaged or hostile.
constexpr std::int64_t kMaxTexels = std::int64_t{1} << 31;

int kept_channels(const OIIO::ImageSpec& spec) { return spec.nchannels >= 3 ? 3 : 1; }

template <typename T>
std::vector<T> read_channels(OIIO::ImageInput& input, int channels, OIIO::TypeDesc type) {
  const OIIO::ImageSpec& spec = input.spec();
  std::vector<T> texels(static_cast<std::size_t>(spec.width) *
                        static_cast<std::size_t>(spec.height) * static_cast<std::size_t>(channels));
  if (!input.read_image(0, 0, 0, channels, type, texels.data())) throw IoError(input.geterror());
  return texels;
}

}  // namespace

TexelImage read_texel_image(const std::string& path) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path, &config);
  if (!input) throw IoError(OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  const std::int64_t texels = std::int64_t{spec.width} * spec.height;
  if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || spec.nchannels < 1 ||
      texels > kMaxTexels) {
    throw IoError("the image has an unusable size");
  }
  TexelImage image;
  image.width = spec.width;
  image.height = spec.height;
  image.channels = kept_channels(spec);
  switch (spec.format.basetype) {
    case OIIO::TypeDesc::UINT8:
      image.texels = read_channels<std::uint8_t>(*input, image.channels, OIIO::TypeDesc::UINT8);
      break;
    case OIIO::TypeDesc::UINT16:
      image.texels = read_channels<std::uint16_t>(*input, image.channels, OIIO::TypeDesc::UINT16);
      break;
    case OIIO::TypeDesc::HALF:
      image.texels = read_channels<Imath::half>(*input, image.channels, OIIO::TypeDesc::HALF);
      break;
    default:
      image.texels = read_channels<float>(*input, image.channels, OIIO::TypeDesc::FLOAT);
  }
  return image;
}

ImageSize image_size(const std::string& path) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) {
    OIIO::geterror();  // else it would be told when the program ends
    return {};
  }
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width <= 0 || spec.height <= 0) return {};
  ImageSize size;
  size.texels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
  constexpr std::array<unsigned char, 3> kSmallTypes = {
      OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::HALF};
  const bool is_small_type =
      std::find(kSmallTypes.begin(), kSmallTypes.end(), spec.format.basetype) != kSmallTypes.end();
  const std::uint64_t channel_bytes = is_small_type ? spec.format.size() : sizeof(float);
  size.bytes = size.texels * static_cast<std::uint64_t>(kept_channels(spec)) * channel_bytes;
  return size;
}

std::map<std::string, CachedImage> read_images(std::span<const std::string> paths) {
  const std::set<std::string> unique(paths.begin(), paths.end());
  const std::vector<std::string> todo(unique.begin(), unique.end());
  std::vector<CachedImage> images(todo.size());
  parallel_for(todo.size(), [&](std::size_t i) {
    try {
      images[i].image = std::make_shared<const TexelImage>(read_texel_image(todo[i]));
    } catch (const std::exception& error) {
      images[i].error = error.what();
    }
  });
  std::map<std::string, CachedImage> result;
  for (std::size_t i = 0; i < todo.size(); ++i) result.emplace(todo[i], std::move(images[i]));
  return result;
}

}  // namespace ajar
