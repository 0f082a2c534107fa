// Any bytes must be an image of ours, or raise IoError: as a picture, as a texture, and as what a
// scene's size is estimated from. The first byte says what the file is called.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/error.h"
#include "image/image_file.h"
#include "scene/texture/image_cache.h"
#include "support/private_file.h"

namespace {
constexpr std::array<const char*, 6> kExtensions = {".pfm", ".exr", ".png", ".jpg", ".hdr", ".tif"};
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string path = ajar::fuzz::private_file(std::span(data, size).subspan(1),
                                                    kExtensions[data[0] % kExtensions.size()]);
  try {
    const ajar::Image image = ajar::read_image(path);
    image.rgb();
  } catch (const ajar::IoError&) {
  }
  try {
    ajar::image_size(path);
    ajar::read_texel_image(path);
  } catch (const ajar::IoError&) {
  }
  return 0;
}
