#pragma once
#include <cstddef>
#include <vector>

#include "core/vector.h"

namespace ajar {

/// One channel of an image.
struct Plane {
  Vec2i size{0, 0};
  std::vector<float> values;  ///< row by row

  explicit Plane(Vec2i plane_size)
      : size(plane_size),
        values(static_cast<std::size_t>(plane_size.x) * static_cast<std::size_t>(plane_size.y)) {}
  float& at(int x, int y) { return values[index(x, y)]; }
  float at(int x, int y) const { return values[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(x);
  }
};

}  // namespace ajar
