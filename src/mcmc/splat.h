#pragma once
#include <cstdint>
#include <vector>

#include "core/spectrum.h"
#include "core/vector.h"

namespace ajar {

/// Light on one place of the film: f / p of a state, MIS weight included.
struct Splat {
  Vec2 raster;         ///< pixels of the full image
  std::int32_t layer;  ///< layer of the film
  Spectrum value;
};
using SplatBuffer = std::vector<Splat>;

}  // namespace ajar
