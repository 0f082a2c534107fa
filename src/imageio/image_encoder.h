#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/vector.h"

/// What writes the formats of image files, in memory, so that every failure of the disk is ours to
/// see: most format libraries ignore errors of the last flush. In `image_formats/`.
namespace ajar {

/// An image to be encoded, but for its pixels.
struct ImageLayout {
  int width = 0;
  int height = 0;
  std::vector<std::string> names;  ///< names of the channels
  Vec2i origin{0, 0};              ///< place of the first pixel in the whole picture; only EXR has
                                   ///< both
  Vec2i resolution{0, 0};          ///< size of the whole picture
  std::map<std::string, std::string> texts;  ///< where the format has room for them
};

/// Fills a row, channels interleaved; called for each, from the top.
template <typename T>
using RowSource = std::function<void(int y, T* row)>;

// Raise IoError with the reason.
/// 32-bit floats of any channels, ZIP.
std::vector<unsigned char> encode_exr(const ImageLayout& layout, const RowSource<float>& row);
/// Channels R, G, B from 0 to 1e38.
std::vector<unsigned char> encode_hdr(const ImageLayout& layout, const RowSource<float>& row);
/// Channels R, G, B as they are shown, and A if there are four.
std::vector<unsigned char> encode_png(const ImageLayout& layout,
                                      const RowSource<unsigned char>& row);
/// Encodes as JPEG, quality 95.
std::vector<unsigned char> encode_jpeg(const ImageLayout& layout,
                                       const RowSource<unsigned char>& row);

}  // namespace ajar
