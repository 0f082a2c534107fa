#pragma once
#include <half.h>

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "scene/desc/scene_desc.h"

namespace ajar {

/// Texels of an image file as stored there: integers stay encoded, floats are linear. Row 0 is the
/// top row.
struct TexelImage {
  int width = 0;
  int height = 0;
  int channels = 1;                  ///< 1 (gray) or 3
  bool has_other_primaries = false;  ///< than those that its colours are taken for
  std::string remark;                ///< on its channels (`ColorChannels`)
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<Imath::half>,
               std::vector<float>>
      texels;
};

/// Channels that are read from an image.
enum class ImageChannel {
  Color,
  Red,
  Green,
  Blue,
  Alpha,
  AlphaOrColor,        ///< alpha; the colours if there is none
  VaryingAlphaOrColor  ///< alpha beside three colours, unless it is 1 everywhere; else the colours
};

/// An image file, or one of the scene's embedded files, and its selected channels.
struct ImageRequest {
  std::string path;
  ImageChannel channel = ImageChannel::Color;
  auto operator<=>(const ImageRequest&) const = default;
};

/// Reads an image. The colours of a gray image are its gray; without an alpha channel, alpha is 1.
/// Colours are not multiplied with alpha. Throws IoError with the reason.
TexelImage read_texel_image(const ImageRequest& request, const desc::EmbeddedFiles& embedded = {});

/// Memory that an image will take, by its file's header.
struct ImageSize {
  std::uint64_t texels = 0;
  std::uint64_t bytes = 0;
};
/// Without reading the texels; nothing if the file cannot be read, or not into the memory there is.
ImageSize image_size(const ImageRequest& request, const desc::EmbeddedFiles& embedded = {});

/// Result of reading a file: an image, or the reason why there is none.
struct CachedImage {
  std::shared_ptr<const TexelImage> image;
  std::string error;
};
using ImageMap = std::map<ImageRequest, CachedImage>;
/// Reads everything once, several at a time.
ImageMap read_images(std::span<const ImageRequest> requests,
                     const desc::EmbeddedFiles& embedded = {});

}  // namespace ajar
