#include <algorithm>
#include <array>
#include <cmath>

#include "imageio/image_encoder.h"

namespace ajar {

namespace {

using Bytes = std::vector<unsigned char>;

std::array<unsigned char, 4> rgbe_of(const float* rgb) {
  const float largest = std::max({rgb[0], rgb[1], rgb[2]});
  constexpr float kLeast = 1e-32F;
  if (!(largest >= kLeast)) return {};
  int exponent = 0;
  const float scale = std::frexp(largest, &exponent) * 256.F / largest;
  const auto byte = [&](float value) { return static_cast<unsigned char>(value * scale); };
  return {byte(rgb[0]), byte(rgb[1]), byte(rgb[2]), static_cast<unsigned char>(exponent + 128)};
}

/// One component of a row in runs, as `HdrReader::read_planes` reads it.
void append_runs(const Bytes& plane, Bytes& to) {
  constexpr std::size_t kLongestRun = 127;
  constexpr std::size_t kLongestLiteral = 128;
  constexpr std::size_t kWorthIt = 4;
  const auto run_at = [&](std::size_t x) {
    std::size_t end = x + 1;
    while (end < plane.size() && end - x < kLongestRun && plane[end] == plane[x]) ++end;
    return end - x;
  };
  for (std::size_t x = 0; x < plane.size();) {
    std::size_t literal = 0;
    std::size_t run = run_at(x);
    while (run < kWorthIt && literal + run <= kLongestLiteral &&
           x + literal + run <= plane.size()) {
      literal += run;
      if (x + literal == plane.size()) break;
      run = run_at(x + literal);
    }
    if (literal > 0) {
      to.push_back(static_cast<unsigned char>(literal));
      to.insert(to.end(), plane.begin() + static_cast<std::ptrdiff_t>(x),
                plane.begin() + static_cast<std::ptrdiff_t>(x + literal));
      x += literal;
      continue;
    }
    to.push_back(static_cast<unsigned char>(128 + run));
    to.push_back(plane[x]);
    x += run;
  }
}

}  // namespace

Bytes encode_hdr(const ImageLayout& layout, const RowSource<float>& row) {
  const std::string start = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " +
                            std::to_string(layout.height) + " +X " + std::to_string(layout.width) +
                            "\n";
  Bytes bytes(start.begin(), start.end());
  const auto width = static_cast<std::size_t>(layout.width);
  const bool in_runs = layout.width >= 8 && layout.width <= 0x7fff;
  std::vector<float> values(3 * width);
  std::array<Bytes, 4> planes;
  planes.fill(Bytes(width));
  for (int y = 0; y < layout.height; ++y) {
    row(y, values.data());
    for (std::size_t x = 0; x < width; ++x) {
      const auto pixel = rgbe_of(values.data() + 3 * x);
      for (std::size_t c = 0; c < 4; ++c) planes[c][x] = pixel[c];
      if (!in_runs) bytes.insert(bytes.end(), pixel.begin(), pixel.end());
    }
    if (!in_runs) continue;
    bytes.insert(bytes.end(), {2, 2, static_cast<unsigned char>(width >> 8U),
                               static_cast<unsigned char>(width & 0xffU)});
    for (const Bytes& plane : planes) append_runs(plane, bytes);
  }
  return bytes;
}

}  // namespace ajar
