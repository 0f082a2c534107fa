#pragma once
#include <vector>

#include "scene/desc/shape_data.h"

namespace ajar::pbrt {

/// Content of one pbrt curve: segments that share their ends, and a width that changes evenly over
/// all of them.
struct CurveChain {
  std::vector<Vec3> points;   ///< 3 for each segment, and 1
  std::vector<Vec3> normals;  ///< 1 for each segment, and 1; or none
  float width0 = 0.F, width1 = 0.F;
};

/// Curves as few of those. Segments are halved until their widths change evenly, to one part in a
/// thousand.
std::vector<CurveChain> curve_chains(const desc::Curves& curves);

}  // namespace ajar::pbrt
