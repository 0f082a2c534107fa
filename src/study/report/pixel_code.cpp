#include "study/report/pixel_code.h"

#include <half.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace ajar {

namespace {

std::uint16_t half_bits(float value) {
  constexpr float kLargest = 65504.F;
  if (std::isfinite(value)) value = std::clamp(value, -kLargest, kLargest);
  return half(value).bits();
}

std::vector<std::byte> split_planes(std::span<const float> pixels, std::size_t channels) {
  const std::size_t count = pixels.size() / channels;
  std::vector<std::byte> planes(2 * pixels.size());
  for (std::size_t channel = 0; channel < channels; ++channel) {
    std::byte* low = planes.data() + 2 * count * channel;
    std::byte* high = low + count;
    std::uint16_t before = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint16_t bits = half_bits(pixels[i * channels + channel]);
      const auto difference = static_cast<std::uint16_t>(bits - before);
      const auto sign = static_cast<std::uint16_t>((difference & 0x8000U) != 0 ? 0xffff : 0);
      const auto folded = static_cast<std::uint16_t>((difference << 1U) ^ sign);
      low[i] = static_cast<std::byte>(folded & 0xffU);
      high[i] = static_cast<std::byte>(folded >> 8U);
      before = bits;
    }
  }
  return planes;
}

}  // namespace

std::vector<std::byte> pack_pixels(std::span<const float> pixels, int channels) {
  const std::vector<std::byte> planes = split_planes(pixels, static_cast<std::size_t>(channels));
  uLongf size = compressBound(planes.size());
  std::vector<std::byte> packed(size);
  // Level 4: on renders, higher ones take three times as long for two percent.
  const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                               reinterpret_cast<const Bytef*>(planes.data()), planes.size(), 4);
  if (status != Z_OK) throw std::runtime_error("zlib cannot pack the pixels");
  packed.resize(size);
  return packed;
}

}  // namespace ajar
