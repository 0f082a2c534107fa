#pragma once

#include "core/spectrum.h"

namespace ajar {

/// Optical depth of a medium along a piece of a ray.
struct Column {
  float distance;  ///< length of the piece, scene units
  float density;   ///< integral of the density along it, scene units; where it is 1, the length
  bool reached;    ///< ends because the requested integral is reached
};

/// A crossed piece with coefficients.
struct Crossing {
  float distance;  ///< length of the piece, scene units
  Spectrum depth;  ///< optical depth per lane: integral of the extinction along it, finite
  bool reached;    ///< ends because the requested depth of a lane is reached
};

}  // namespace ajar
