#pragma once
#include <half.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "core/vector.h"

namespace ajar {

/// How values of channels are kept. Whole numbers stand for the range from 0 to 1.
enum class SampleType { UInt8, UInt16, Half, Float };

inline std::size_t size_of(SampleType type) {
  return type == SampleType::UInt8 ? 1 : type == SampleType::Float ? 4 : 2;
}

template <typename T>
constexpr SampleType sample_type_of() {
  if (std::is_same_v<T, std::uint8_t>) return SampleType::UInt8;
  if (std::is_same_v<T, std::uint16_t>) return SampleType::UInt16;
  if (std::is_same_v<T, Imath::half>) return SampleType::Half;
  static_assert(sizeof(T) <= sizeof(float) && (std::is_unsigned_v<T> || !std::is_integral_v<T>));
  return SampleType::Float;
}

/// What an image file says of its pixels.
struct ImageHeader {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<std::string> names;  ///< of the channels, "R", "albedo.R", …
  int alpha_channel = -1;          ///< -1: there is none
  /// As the file has them; Float for what is none of the others.
  SampleType type = SampleType::Float;
  bool is_integer = false;
  /// Whether its red, green and blue are said to be others than those of Rec. 709, as which all
  /// colours are taken.
  bool has_other_primaries = false;
  Vec2i origin{0, 0};      ///< of the first pixel in the whole picture
  Vec2i resolution{0, 0};  ///< of the whole picture
  std::map<std::string, std::string> texts;

  std::uint64_t pixels() const {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  }
};

}  // namespace ajar
