#include "apps/viewer/frame.h"

#include <half.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace ajar::viewer {

namespace {

template <typename T>
void put(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.append(raw.data(), raw.size());
}

std::uint16_t half_bits(float value) {
  constexpr float kMost = 65504.F;
  if (std::isnan(value)) return half::qNan().bits();
  return half(std::clamp(value, -kMost, kMost)).bits();
}

bool is_number_of_something(const std::string& layer) {
  return layer.ends_with("-id") || layer == "regions";
}

}  // namespace

std::string encode_frame(const Picture& picture, const Picture::Layer& layer,
                         const FrameHeader& header) {
  const Vec2i size = picture.crop.size() + Vec2i(1, 1);
  const int step = std::max(1, header.step);
  const int columns = (size.x + step - 1) / step;
  const int rows = (size.y + step - 1) / step;
  const auto channels = static_cast<std::size_t>(layer.channels);
  std::string bytes;
  bytes.reserve(64 + layer.name.size() +
                2 * channels * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  bytes += "AJF1";
  put(bytes, header.number);
  put(bytes, header.epoch);
  for (const int value : {picture.resolution.x, picture.resolution.y, picture.crop.min.x,
                          picture.crop.min.y, size.x, size.y, step}) {
    put(bytes, static_cast<std::uint16_t>(value * header.coarseness));
  }
  put(bytes, static_cast<std::uint8_t>(layer.channels));
  const std::size_t name = std::min<std::size_t>(layer.name.size(), 255);
  put(bytes, static_cast<std::uint8_t>(name));
  bytes.append(layer.name, 0, name);
  while (bytes.size() % 4 != 0) bytes += '\0';

  const bool takes_first = is_number_of_something(layer.name);
  const auto width = static_cast<std::size_t>(size.x);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int x_end = takes_first ? column * step + 1 : std::min((column + 1) * step, size.x);
      const int y_end = takes_first ? row * step + 1 : std::min((row + 1) * step, size.y);
      const auto count = static_cast<float>((x_end - column * step) * (y_end - row * step));
      for (std::size_t c = 0; c < channels; ++c) {
        float sum = 0.F;
        for (int y = row * step; y < y_end; ++y) {
          for (int x = column * step; x < x_end; ++x) {
            sum +=
                layer.pixels[(static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) *
                                 channels +
                             c];
          }
        }
        put(bytes, half_bits(sum / count));
      }
    }
  }
  return bytes;
}

}  // namespace ajar::viewer
