#pragma once
#include <vector>

#include "core/vector.h"

namespace ajar::pbrt {

/// Linear colours, row by row from the top.
struct LinearImage {
  int width = 0, height = 0;
  bool is_8_bit = false;  ///< in the file
  std::vector<Vec3> texels;

  const Vec3& at(int x, int y) const {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// A square of equal areas (core/sphere_mapping.h) as rows of one latitude, twice as wide.
LinearImage rows_of_latitude(const LinearImage& equal_area);

/// Radiance of the clear sky of the model "sky", 512 × 256.
LinearImage clear_sky(float turbidity, float elevation, float scale);

/// Luminance of a map of latitudes: of all directions together, and on a surface that faces z.
double luminance_all_around(const LinearImage& latitudes);
double luminance_from_above(const LinearImage& latitudes);

}  // namespace ajar::pbrt
