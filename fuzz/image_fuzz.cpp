// Any bytes must be an image of ours, or raise IoError: as a picture, as a texture, and as an input
// of the estimate of a scene's size. The first byte selects the name of the file.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/error.h"
#include "imageio/image_file.h"
#include "scene/texture/image_cache.h"
#include "support/private_file.h"

namespace {
constexpr std::array<const char*, 6> kExtensions = {".pfm", ".exr", ".png", ".jpg", ".hdr", ".tif"};
/// A picture of one colour may rightly have more than a gigabyte of values in a few bytes of file;
/// whether that much memory is available is no subject here.
constexpr std::uint64_t kMostTexels = std::uint64_t{1} << 26U;
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string path = ajar::fuzz::private_file(std::span(data, size).subspan(1),
                                                    kExtensions[data[0] % kExtensions.size()]);
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
