#pragma once
#include "core/spectrum.h"
#include "core/vector.h"

namespace ajar {

/// A number for each lane of a spectrum, in double precision: products over long paths.
using ByLane = Vec3d;

inline ByLane by_lane(const Spectrum& s) { return ByLane(Vec3(s[0], s[1], s[2])); }

/// The mean over lanes; of equal ones exactly their value, so that grey media behave as one lane.
inline double mean(const ByLane& lanes) {
  if (lanes.x == lanes.y && lanes.x == lanes.z) return lanes.x;
  return (lanes.x + lanes.y + lanes.z) / 3.0;
}

}  // namespace ajar
