#pragma once
#include <half.h>

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace ajar {

/// Texels of an image file as stored there: integers stay encoded, floats are linear. Row 0 is the
/// top row.
struct TexelImage {
  int width = 0;
  int height = 0;
  int channels = 1;  ///< 1 (gray) or 3
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<Imath::half>,
               std::vector<float>>
      texels;
};

/// Reads an image; alpha is ignored, not multiplied in. Throws IoError with the reason.
TexelImage read_texel_image(const std::string& path);

/// What an image will take in memory, as its file says.
struct ImageSize {
  std::uint64_t texels = 0;
  std::uint64_t bytes = 0;
};
/// Without reading the texels; nothing if the file cannot be read, or not into the memory there is.
ImageSize image_size(const std::string& path);

/// Result of reading a file: an image, or the reason why there is none.
struct CachedImage {
  std::shared_ptr<const TexelImage> image;
  std::string error;
};
/// Reads every path once, several at a time.
std::map<std::string, CachedImage> read_images(std::span<const std::string> paths);

}  // namespace ajar
