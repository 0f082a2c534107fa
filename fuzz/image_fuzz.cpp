// Any bytes must be an image of ours, or raise IoError: as a picture, as a texture, and as what a
// scene's size is estimated from.
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/error.h"
#include "imageio/image_file.h"
#include "scene/texture/image_cache.h"
#include "support/private_file.h"

namespace {
/// A picture of one colour may rightly have more than a gigabyte of values in a few bytes of file;
/// whether that is to be had is not what is asked here.
constexpr std::uint64_t kMostTexels = std::uint64_t{1} << 26U;
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = ajar::fuzz::private_file(std::span(data, size), ".image");
  if (ajar::image_size({path}).texels > kMostTexels) return 0;
  try {
    const ajar::Image image = ajar::read_image(path);
    image.rgb();
  } catch (const ajar::IoError&) {
  }
  try {
    ajar::read_texel_image({path});
  } catch (const ajar::IoError&) {
  }
  return 0;
}
