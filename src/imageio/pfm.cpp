#include "imageio/pfm.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "core/number_text.h"
#include "os/regular_file.h"

namespace ajar {

static_assert(std::endian::native == std::endian::little, "PFM code assumes little-endian floats");

std::vector<std::byte> encode_pfm(int width, int height, std::span<const float> rgb) {
  const std::string header =
      "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
  const std::size_t row = static_cast<std::size_t>(width) * 3;
  std::vector<std::byte> bytes(header.size() + rgb.size() * sizeof(float));
  std::memcpy(bytes.data(), header.data(), header.size());
  std::byte* out = bytes.data() + header.size();
  for (int y = height - 1; y >= 0; --y, out += row * sizeof(float)) {
    std::memcpy(out, rgb.data() + row * static_cast<std::size_t>(y), row * sizeof(float));
  }
  return bytes;
}

Image read_pfm(const std::string& path) {
  const FileBytes file = read_file(path);
  const std::string_view bytes = file.view();
  const auto broken = [&](const char* why) {
    return IoError("\"" + path + "\" is not a PFM image: " + why);
  };

  // Four words, then exactly one white space, then the floats.
  std::size_t at = 0;
  const auto word = [&]() {
    const auto space = [&](std::size_t i) {
      return std::isspace(static_cast<unsigned char>(bytes[i])) != 0;
    };
    while (at < bytes.size() && space(at)) ++at;
    std::string text;
    while (at < bytes.size() && !space(at) && text.size() < 32) text += bytes[at++];
    return text;
  };
  const auto number = [&]() {
    const std::optional<double> value = number_of(word());
    if (!value) throw broken("bad header");
    return *value;
  };
  const std::string magic = word();
  if (magic != "PF" && magic != "Pf") throw broken("it does not start with PF");
  const double width = number();
  const double height = number();
  const double scale = number();
  ++at;
  constexpr double kLargestSide = 1 << 20;
  if (!(width >= 1 && width <= kLargestSide && height >= 1 && height <= kLargestSide) ||
      scale == 0.0) {
    throw broken("bad header");
  }
  Image image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.channels = magic == "PF" ? 3 : 1;
  image.names =
      image.channels == 3 ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
  image.resolution = {image.width, image.height};
  const std::size_t row =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  const std::size_t size = row * static_cast<std::size_t>(image.height);
  if (at > bytes.size() || (bytes.size() - at) / sizeof(float) < size)
    throw broken("it is truncated");

  image.data.resize(size);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    const std::size_t from_bottom = static_cast<std::size_t>(image.height) - 1 - y;
    std::memcpy(image.data.data() + y * row, bytes.data() + at + from_bottom * row * sizeof(float),
                row * sizeof(float));
  }
  if (scale > 0.0) {
    for (float& value : image.data) {
      value = std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
    }
  }
  return image;
}

}  // namespace ajar
