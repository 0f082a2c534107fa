#pragma once
#include <vector>

namespace ajar {

/// What a camera ray sees first that is neither a mirror nor clear glass, row by row, RGB or xyz
/// interleaved; both empty where nobody knows. They tell a filter light from surfaces.
struct Features {
  std::vector<float> albedo;  ///< what is reflected of the light, or emitted, in [0, 1]
  std::vector<float> normal;  ///< in world space, toward the viewer, of length 1 at most
  bool empty() const { return albedo.empty(); }
};

}  // namespace ajar
