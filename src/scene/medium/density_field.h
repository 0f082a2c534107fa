#pragma once
#include <cstdint>

#include "scene/desc/density_grid.h"
#include "scene/medium/column.h"
#include "scene/medium/lattice.h"

namespace ajar {

/// The density of a medium that has a grid. Along a ray it is a cubic polynomial per cell, so that
/// its integral is known but for rounding: no distance is sampled by rejection, and transmittance
/// is no estimate. Bricks of cells in which the density is the same everywhere, such as empty ones,
/// are crossed at once.
class DensityField {
 public:
  /// `density` must be free of complaints, and without colours.
  explicit DensityField(const desc::Density& density);

  /// Density at a point of the world, positive: points outside of the box count as the nearest in
  /// it, and vacuum as very thin. Light scatters at neither, but rounding puts points there.
  float at(const Vec3& p) const;
  /// Along `ray` for `distance`, or until the integral of the density is `most`. Infinite distances
  /// end where the box does, for the integral.
  Column along(const Ray& ray, float distance, float most) const;
  bool is_vacuum() const { return largest_ == 0.F; }

  /// Memory beside the grid, bytes.
  static std::uint64_t memory(const desc::DensityGrid& grid) { return Bricks::memory(grid); }

 private:
  using Bricks = LatticeBricks<float>;

  std::array<double, 8> corners(const Lattice::Cell& cell) const;

  desc::DensityGridPointer grid_;
  Lattice lattice_;
  Bricks bricks_;
  float largest_ = 0.F;
};

}  // namespace ajar
