#pragma once

namespace ajar {

/// What light meets of a medium along a piece of a ray.
struct Column {
  float distance;  ///< length of the piece, scene units
  float density;   ///< integral of the density along it, scene units; where it is 1, the length
  bool reached;    ///< ends because the integral is what was asked for
};

}  // namespace ajar
