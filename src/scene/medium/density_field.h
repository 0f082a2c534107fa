#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "scene/desc/density_grid.h"
#include "scene/medium/column.h"
#include "scene/ray.h"

namespace ajar {

/// The density of a medium that has a grid. Along a ray it is a cubic polynomial per cell, so that
/// its integral is known but for rounding: no distance is sampled by rejection, and transmittance
/// is no estimate. Cells lie between the points of the lattice; bricks of cells in which the
/// density is the same everywhere, such as empty ones, are crossed at once.
/// Source of the walk through cells: Amanatides & Woo 1987.
class DensityField {
 public:
  /// `density` must be free of complaints.
  explicit DensityField(const desc::Density& density);

  /// Density at a point of the world, positive: what lies outside of the box counts as the nearest
  /// point in it, and vacuum as very thin. Light scatters at neither, but rounding puts points
  /// there.
  float at(const Vec3& p) const;
  /// Along `ray` for `distance`, or until the integral of the density is `most`. Infinite distances
  /// end where the box does, for the integral.
  Column along(const Ray& ray, float distance, float most) const;
  bool is_vacuum() const { return largest_ == 0.F; }

  /// Memory beside the grid, bytes.
  static std::uint64_t memory(const desc::DensityGrid& grid);

 private:
  /// Part of a ray that is inside of the box; `origin` and `direction` are those of the lattice,
  /// whose points have whole coordinates. `begin` and `end` are distances in the world.
  struct Inside {
    Vec3d origin, direction;
    double begin, end;
    Vec3d at(double t) const { return origin + direction * t; }
  };
  /// Cells [low, high), in the middle of which nothing changes if `uniform` is not negative.
  struct Brick {
    float uniform = -1.F;  ///< the density if it is the same in the whole brick
  };
  using Cell = desc::Vec3i;
  using Corners = std::array<double, 8>;

  Inside clip(const Ray& ray, float distance) const;
  /// Visits what the ray crosses one after the other, as `visit(density, from, to)` with distances
  /// and a function of the distance, until it returns true.
  template <typename Visit>
  void walk(const Inside& inside, const Visit& visit) const;
  Corners corners(const Cell& cell) const;
  float value(int x, int y, int z) const;
  const Brick& brick(const Cell& cell) const;
  void find_uniform_bricks();

  desc::DensityGridPointer grid_;
  Mat4 lattice_from_world_;
  Vec3d low_, high_;   ///< the box, in the lattice
  Cell first_, last_;  ///< cells that the box overlaps: cell i is between points i and i + 1
  desc::Vec3i brick_count_;
  std::vector<Brick> bricks_;
  float largest_ = 0.F;
};

}  // namespace ajar
