#include <cstring>
#include <string>

#include "imageio/image_encoder.h"

namespace ajar {

std::vector<unsigned char> encode_pfm(const ImageLayout& layout, const RowSource<float>& row) {
  // A negative scale stands for little-endian floats.
  const std::string start =
      "PF\n" + std::to_string(layout.width) + " " + std::to_string(layout.height) + "\n-1.0\n";
  std::vector<float> values(static_cast<std::size_t>(layout.width) * 3);
  const std::size_t row_bytes = values.size() * sizeof(float);
  std::vector<unsigned char> bytes(start.begin(), start.end());
  bytes.resize(start.size() + row_bytes * static_cast<std::size_t>(layout.height));
  for (int y = 0; y < layout.height; ++y) {
    row(y, values.data());
    const auto from_bottom = static_cast<std::size_t>(layout.height - 1 - y);
    std::memcpy(bytes.data() + start.size() + from_bottom * row_bytes, values.data(), row_bytes);
  }
  return bytes;
}

}  // namespace ajar
