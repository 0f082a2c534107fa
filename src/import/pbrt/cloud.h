#pragma once
#include <cstdint>

#include "scene/desc/density_grid.h"

namespace ajar::pbrt {

/// The procedural cloud of pbrt-v4.
struct Cloud {
  float density = 1.F, wispiness = 1.F, frequency = 5.F;
  Vec3 low{0.F}, high{1.F};  ///< its box, in the space of the medium

  /// At a point of that space, 0 to 1. Source: Pharr et al. 2023, section 11.4.5.
  float at(const Vec3& p) const;
};

/// Whether a grid that shows the finest noise of the cloud is larger than one that is made.
bool is_finer_than_grids(const Cloud& cloud);

/// Of the grid that is made.
std::uint64_t grid_bytes(const Cloud& cloud);

/// The density at the points of a lattice, two for each period of the finest noise, or fewer. Its
/// unit cube is the box.
desc::DensityGrid tabulate(const Cloud& cloud);

}  // namespace ajar::pbrt
