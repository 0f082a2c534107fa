#include "scene/texture/image_cache.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/available_memory.h"
#include "core/error.h"
#include "core/image_input.h"
#include "core/parallel_for.h"

namespace ajar {

namespace {

int kept_channels(const OIIO::ImageSpec& spec) { return spec.nchannels >= 3 ? 3 : 1; }

}  // namespace

TexelImage read_texel_image(const std::string& path) {
  ImageInput input(path, true);
  const OIIO::ImageSpec& spec = input.spec();
  TexelImage image;
  image.width = spec.width;
  image.height = spec.height;
  image.channels = kept_channels(spec);
  switch (spec.format.basetype) {
    case OIIO::TypeDesc::UINT8:
      image.texels = input.read<std::uint8_t>(image.channels);
      break;
    case OIIO::TypeDesc::UINT16:
      image.texels = input.read<std::uint16_t>(image.channels);
      break;
    case OIIO::TypeDesc::HALF:
      image.texels = input.read<Imath::half>(image.channels);
      break;
    default:
      image.texels = input.read<float>(image.channels);
  }
  return image;
}

ImageSize image_size(const std::string& path) {
  try {
    const ImageInput input(path);
    const OIIO::ImageSpec& spec = input.spec();
    constexpr std::array<unsigned char, 3> kSmallTypes = {
        OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::HALF};
    const bool is_small_type = std::find(kSmallTypes.begin(), kSmallTypes.end(),
                                         spec.format.basetype) != kSmallTypes.end();
    const std::uint64_t channel_bytes = is_small_type ? spec.format.size() : sizeof(float);
    if (!memory_shortage(input.bytes(kept_channels(spec), channel_bytes)).empty()) return {};
    const auto channels = static_cast<std::uint64_t>(kept_channels(spec));
    return {input.pixels(), input.pixels() * channels * channel_bytes};
  } catch (const IoError&) {
    return {};
  }
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
