#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "scene/desc/density_grid.h"
#include "scene/ray.h"

namespace ajar {

/// The points of a grid in their place, and the cells between them. Source of the walk through
/// cells: Amanatides & Woo 1987.
class Lattice {
 public:
  using Cell = desc::Vec3i;  ///< between the points i and i + 1
  /// Part of a ray that is inside of the box; `origin` and `direction` are those of the lattice,
  /// whose points have whole coordinates. `begin` and `end` are distances in the world.
  struct Inside {
    Vec3d origin, direction;
    double begin, end;
    Vec3d at(double t) const { return origin + direction * t; }
  };
  struct Place {
    Cell cell;
    Vec3d inside;  ///< each coordinate in [0, 1]
  };

  /// `density` must be free of complaints.
  explicit Lattice(const desc::Density& density);

  /// Place of a point of the world, or of the nearest one in the box.
  Place locate(const Vec3& p) const;
  Inside clip(const Ray& ray, float distance) const;

  /// `value_at(index)` of a point, the index being that in arrays of the grid. Outside of the grid:
  /// `beyond`, or the value of the nearest one if the grid's border is clamped.
  template <typename Value, typename ValueAt>
  Value value(const Cell& point, const ValueAt& value_at, const Value& beyond) const;
  /// Values at the corners of a cell; x varies fastest, then y.
  template <typename Value, typename ValueAt>
  std::array<Value, 8> corners(const Cell& cell, const ValueAt& value_at,
                               const Value& beyond) const;

  /// Visits the cells that a ray crosses one after the other, as `visit(brick, cell, from, to)`
  /// with distances, until it returns true. Bricks that are uniform are visited as one.
  template <typename Bricks, typename Visit>
  void walk(const Inside& inside, const Bricks& bricks, const Visit& visit) const;

  /// Cells that the box overlaps.
  const Cell& first() const { return first_; }
  const Cell& last() const { return last_; }

 private:
  desc::Vec3i resolution_;
  bool is_clamped_;
  Mat4 lattice_from_world_;
  Vec3d low_, high_;  ///< the box, in the lattice
  Cell first_, last_;
};

/// Bricks of cells: those in which the value is the same everywhere know it.
template <typename Value>
class LatticeBricks {
 public:
  static constexpr int kSide = 8;  ///< cells

  struct Brick {
    bool is_uniform() const { return first_of(uniform) >= 0; }
    Value uniform = Value(-1);

   private:
    static double first_of(double value) { return value; }
    static double first_of(const Vec3d& value) { return value.x; }
  };

  /// Looks at all points, by `value_at(point)`, which is not negative.
  template <typename ValueAt>
  LatticeBricks(const Lattice& lattice, const ValueAt& value_at);

  const Brick& at(const desc::Vec3i& cell) const {
    const desc::Vec3i at = (cell - first_) / kSide;
    const auto row = static_cast<std::size_t>(at.z) * static_cast<std::size_t>(count_.y) +
                     static_cast<std::size_t>(at.y);
    return bricks_[row * static_cast<std::size_t>(count_.x) + static_cast<std::size_t>(at.x)];
  }
  desc::Vec3i first_cell(const desc::Vec3i& cell) const {
    return first_ + (cell - first_) / kSide * kSide;
  }

  /// Memory, bytes.
  static std::uint64_t memory(const desc::DensityGrid& grid) {
    // Centers have a cell more along each axis than there are points.
    return product(bricks_of(grid.resolution + desc::Vec3i(1))) * sizeof(Brick);
  }

 private:
  static desc::Vec3i bricks_of(const desc::Vec3i& cells) {
    return (cells + desc::Vec3i(kSide - 1)) / kSide;
  }
  static std::size_t product(const desc::Vec3i& n) {
    return static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) *
           static_cast<std::size_t>(n.z);
  }

  desc::Vec3i first_, count_;
  std::vector<Brick> bricks_;
};

template <typename Value, typename ValueAt>
Value Lattice::value(const Cell& point, const ValueAt& value_at, const Value& beyond) const {
  const desc::Vec3i& n = resolution_;
  Cell p = point;
  const bool is_inside = p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < n.x && p.y < n.y && p.z < n.z;
  if (!is_inside) {
    if (!is_clamped_) return beyond;
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::clamp(p[axis], 0, n[axis] - 1);
  }
  const auto row =
      static_cast<std::size_t>(p.z) * static_cast<std::size_t>(n.y) + static_cast<std::size_t>(p.y);
  return value_at(row * static_cast<std::size_t>(n.x) + static_cast<std::size_t>(p.x));
}

template <typename Value, typename ValueAt>
std::array<Value, 8> Lattice::corners(const Cell& cell, const ValueAt& value_at,
                                      const Value& beyond) const {
  const desc::Vec3i& n = resolution_;
  std::array<Value, 8> result;
  const int x = cell.x;
  const int y = cell.y;
  const int z = cell.z;
  if (x >= 0 && y >= 0 && z >= 0 && x + 1 < n.x && y + 1 < n.y && z + 1 < n.z) {
    const auto row = static_cast<std::size_t>(n.x);
    const std::size_t plane = row * static_cast<std::size_t>(n.y);
    const std::size_t first = static_cast<std::size_t>(z) * plane +
                              static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x);
    for (std::size_t i = 0; i < 8; ++i) {
      result[i] = value_at(first + (i & 1U) + ((i >> 1U) & 1U) * row + (i >> 2U) * plane);
    }
    return result;
  }
  for (int i = 0; i < 8; ++i) {
    result[static_cast<std::size_t>(i)] =
        value(cell + Cell(i & 1, (i >> 1) & 1, i >> 2), value_at, beyond);
  }
  return result;
}

template <typename Bricks, typename Visit>
void Lattice::walk(const Inside& inside, const Bricks& bricks, const Visit& visit) const {
  double t = inside.begin;
  if (!(t < inside.end)) return;
  const auto cell_along = [&](int axis, double at, int low, int high) {
    const double x = inside.origin[axis] + inside.direction[axis] * at;
    return static_cast<int>(
        std::clamp(std::floor(x), static_cast<double>(low), static_cast<double>(high)));
  };
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    cell[axis] = cell_along(axis, t, first_[axis], last_[axis]);
  }
  while (true) {
    const auto& brick = bricks.at(cell);
    const bool is_uniform = brick.is_uniform();
    const Cell low = is_uniform ? bricks.first_cell(cell) : cell;
    const Cell high = low + Cell(is_uniform ? Bricks::kSide : 1);
    double exit = std::numeric_limits<double>::infinity();
    int exit_axis = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double direction = inside.direction[axis];
      if (direction == 0.0) continue;
      const double border = static_cast<double>(direction > 0.0 ? high[axis] : low[axis]);
      const double to_border = (border - inside.origin[axis]) / direction;
      if (to_border < exit) {
        exit = to_border;
        exit_axis = axis;
      }
    }
    const double to = std::clamp(exit, t, inside.end);
    if ((is_uniform || to > t) && visit(brick, cell, t, to)) return;
    if (exit >= inside.end) return;
    // Rounding may have put the ray a little off the cell; it always goes on, though.
    for (int axis = 0; axis < 3 && is_uniform; ++axis) {
      const int last = std::min(high[axis] - 1, last_[axis]);
      if (axis != exit_axis) cell[axis] = cell_along(axis, to, low[axis], last);
    }
    cell[exit_axis] = inside.direction[exit_axis] > 0.0 ? high[exit_axis] : low[exit_axis] - 1;
    if (cell[exit_axis] < first_[exit_axis] || cell[exit_axis] > last_[exit_axis]) return;
    t = to;
  }
}

template <typename Value>
template <typename ValueAt>
LatticeBricks<Value>::LatticeBricks(const Lattice& lattice, const ValueAt& value_at)
    : first_(lattice.first()),
      count_(bricks_of(lattice.last() - lattice.first() + desc::Vec3i(1))) {
  bricks_.resize(product(count_));
  std::size_t index = 0;
  for (int bz = 0; bz < count_.z; ++bz) {
    for (int by = 0; by < count_.y; ++by) {
      for (int bx = 0; bx < count_.x; ++bx, ++index) {
        const desc::Vec3i low = first_ + desc::Vec3i(bx, by, bz) * kSide;
        const auto end = [&](int axis) {
          return std::min(low[axis] + kSide, lattice.last()[axis] + 1);
        };
        const Value uniform = value_at(low);
        bool is_uniform = true;
        for (int z = low.z; z <= end(2) && is_uniform; ++z) {
          for (int y = low.y; y <= end(1) && is_uniform; ++y) {
            for (int x = low.x; x <= end(0) && is_uniform; ++x) {
              is_uniform = value_at({x, y, z}) == uniform;
            }
          }
        }
        if (is_uniform) bricks_[index].uniform = uniform;
      }
    }
  }
}

}  // namespace ajar
