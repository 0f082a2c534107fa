#pragma once
#include <vector>

namespace ajar {

/// Auxiliary buffers of the first hit that is neither a mirror nor clear glass, row by row, RGB or
/// xyz interleaved; both empty if unknown.
struct Features {
  std::vector<float> albedo;  ///< reflected share of the light, or emission, in [0, 1]
  std::vector<float> normal;  ///< in world space, toward the viewer, of length 1 at most
  bool empty() const { return albedo.empty(); }
};

}  // namespace ajar
