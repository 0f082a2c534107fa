#include "scene/medium/lattice.h"

namespace ajar {

namespace {

Mat4 lattice_from_cube(const desc::DensityGrid& grid) {
  const bool at_corners = grid.points == desc::DensityGrid::Points::Corners;
  const Vec3d size = Vec3d(grid.resolution) - Vec3d(at_corners ? 1.0 : 0.0);
  const double first = at_corners ? 0.0 : -0.5;
  Mat4 m;
  m.setScale(size);
  m[3][0] = m[3][1] = m[3][2] = first;
  return m;
}

}  // namespace

Lattice::Lattice(const desc::Density& density)
    : resolution_(density.grid->resolution),
      is_clamped_(density.grid->border == desc::DensityGrid::Border::Clamp) {
  const bool at_corners = density.grid->points == desc::DensityGrid::Points::Corners;
  lattice_from_world_ = density.to_world.inverse() * lattice_from_cube(*density.grid);
  low_ = Vec3d(at_corners ? 0.0 : -0.5);
  high_ = Vec3d(resolution_) - Vec3d(at_corners ? 1.0 : 0.5);
  first_ = Cell(at_corners ? 0 : -1);
  last_ = resolution_ - Cell(at_corners ? 2 : 1);
}

Lattice::Place Lattice::locate(const Vec3& p) const {
  Vec3d at;
  lattice_from_world_.multVecMatrix(Vec3d(p), at);
  Place place;
  for (int axis = 0; axis < 3; ++axis) {
    // Comparisons in this order map NaN to a bound.
    const double x = std::min(std::max(low_[axis], at[axis]), high_[axis]);
    place.cell[axis] = std::clamp(static_cast<int>(std::floor(x)), first_[axis], last_[axis]);
    place.inside[axis] = x - static_cast<double>(place.cell[axis]);
  }
  return place;
}

Lattice::Inside Lattice::clip(const Ray& ray, float distance) const {
  Inside inside{{}, {}, 0.0, static_cast<double>(distance)};
  lattice_from_world_.multVecMatrix(Vec3d(ray.origin), inside.origin);
  lattice_from_world_.multDirMatrix(Vec3d(ray.direction), inside.direction);
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = inside.origin[axis];
    const double direction = inside.direction[axis];
    if (direction == 0.0) {
      if (origin < low_[axis] || origin > high_[axis]) inside.end = 0.0;
      continue;
    }
    const double to_low = (low_[axis] - origin) / direction;
    const double to_high = (high_[axis] - origin) / direction;
    inside.begin = std::max(inside.begin, std::min(to_low, to_high));
    inside.end = std::min(inside.end, std::max(to_low, to_high));
  }
  return inside;
}

}  // namespace ajar
