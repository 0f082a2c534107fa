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

/// The same with 0.2 more (at most 1) in rows 10 to 19 of columns 10 to 29.
inline std::vector<float> brighter_patch(std::vector<float> values) {
  for (int y = 10; y < 20; ++y) {
    for (int x = 10; x < 30; ++x) {
      for (int c = 0; c < 3; ++c) {
        float& value = values[static_cast<std::size_t>((y * kPatternSize.x + x) * 3 + c)];
        value = std::min(value + 0.2F, 1.F);
      }
    }
  }
  return values;
}

}  // namespace ajar::testing_images
