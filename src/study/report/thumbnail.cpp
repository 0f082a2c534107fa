#include "study/report/thumbnail.h"

#include <algorithm>
#include <cmath>

namespace ajar {

namespace {

constexpr int kLargestSide = 256;

/// First source pixel of a thumbnail's pixel; the one after the last is that of the next.
int source_begin(int i, int from, int to) {
  return static_cast<int>(static_cast<std::int64_t>(i) * from / to);
}

}  // namespace

Thumbnail make_thumbnail(const ReportImage& image) {
  const int largest = std::max(image.width, image.height);
  const auto scaled = [&](int side) {
    return largest <= kLargestSide ? side : std::max(1, side * kLargestSide / largest);
  };
  Thumbnail small{scaled(image.width), scaled(image.height), {}};
  const ReportLayer& layer = image.layers.front();
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      double sums[3] = {0, 0, 0};
      int count = 0;
      for (int v = source_begin(y, image.height, small.height);
           v < source_begin(y + 1, image.height, small.height); ++v) {
        for (int u = source_begin(x, image.width, small.width);
             u < source_begin(x + 1, image.width, small.width); ++u, ++count) {
          const std::size_t pixel =
              static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(u);
          for (std::size_t c = 0; c < 3; ++c) {
            const float value =
                layer.channels == 3 ? layer.pixels[3 * pixel + c] : layer.pixels[pixel];
            if (std::isfinite(value)) sums[c] += value;
          }
        }
      }
      for (const double sum : sums) small.pixels.push_back(static_cast<float>(sum / count));
    }
  }
  return small;
}

}  // namespace ajar
