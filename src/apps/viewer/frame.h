#pragma once
#include <cstdint>
#include <string>

#include "imageio/picture.h"

namespace ajar::viewer {

struct FrameHeader {
  std::uint32_t number = 0;
  std::uint32_t epoch = 0;
  int step = 1;  ///< each pixel of the frame is the mean of step × step pixels of the picture
  int coarseness = 1;  ///< each of those stands for so many pixels of the image, likewise
};

/// A layer of a picture as the page takes it (docs/develop/live-viewer.md): half floats, those
/// beyond what these can be cut off. Ids and counts keep the first of step × step pixels, as means
/// of them make no sense.
std::string encode_frame(const Picture& picture, const Picture::Layer& layer,
                         const FrameHeader& header);

}  // namespace ajar::viewer
