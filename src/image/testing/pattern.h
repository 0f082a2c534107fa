#pragma once
#include <algorithm>
#include <vector>

#include "core/vector.h"

/// Pictures made of whole numbers, so that a check in another language compares the same ones.
namespace ajar::testing_images {

inline constexpr Vec2i kPatternSize{40, 30};

/// Display values k/63 with k = (x(7 + 3c) + y(5 + 4c) + phase(xy + 3c)) mod 64 in channel c.
inline std::vector<float> pattern(int phase) {
  std::vector<float> values;
  for (int y = 0; y < kPatternSize.y; ++y) {
    for (int x = 0; x < kPatternSize.x; ++x) {
      for (int c = 0; c < 3; ++c) {
        const int k = (x * (7 + 3 * c) + y * (5 + 4 * c) + phase * (x * y + 3 * c)) % 64;
        values.push_back(static_cast<float>(k) / 63.F);
      }
    }
  }
  return values;
}

/// Adds 0.2 (at most 1) in rows 10 to 19 of columns 10 to 29.
inline std::vector<float> brighter_patch(std::vector<float> values) {
  constexpr auto kWidth = static_cast<std::size_t>(kPatternSize.x);
  for (std::size_t y = 10; y < 20; ++y) {
    for (std::size_t i = 3 * (y * kWidth + 10); i < 3 * (y * kWidth + 30); ++i) {
      values[i] = std::min(values[i] + 0.2F, 1.F);
    }
  }
  return values;
}

}  // namespace ajar::testing_images
