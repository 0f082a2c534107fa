#include "scene/medium/density_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ajar {

namespace {

/// Cells along the side of a brick.
constexpr int kBrick = 8;
/// What stands for vacuum at vertices, relative to the largest density: densities of paths are
/// divided by it.
constexpr float kThinnest = 1e-12F;
/// More steps than bisection alone needs.
constexpr int kMaxSteps = 100;

double lerp(double a, double b, double t) { return a + (b - a) * t; }

/// At a place in a cell, each coordinate in [0, 1].
double trilinear(const std::array<double, 8>& c, const Vec3d& p) {
  const double front = lerp(lerp(c[0], c[1], p.x), lerp(c[2], c[3], p.x), p.y);
  const double back = lerp(lerp(c[4], c[5], p.x), lerp(c[6], c[7], p.x), p.y);
  return lerp(front, back, p.z);
}

/// Gauss quadrature with two points, which is exact for cubic polynomials.
template <typename Function>
double integral(const Function& f, double from, double to) {
  const double half = 0.5 * (to - from);
  const double middle = from + half;
  const double offset = half / std::numbers::sqrt3;
  return half * (f(middle - offset) + f(middle + offset));
}

/// Where the integral of `f`, which is not negative, from `from` on is `amount`: between 0 and
/// `whole`, that up to `to`. Newton's method, and bisection where that leads out of the bracket.
template <typename Function>
double invert_integral(const Function& f, double from, double to, double whole, double amount) {
  double low = from;
  double high = to;
  double t = lerp(from, to, amount / whole);
  const double precision = (to - from) * std::numeric_limits<float>::epsilon() * 1e-2;
  for (int i = 0; i < kMaxSteps && high - low > precision; ++i) {
    const double excess = integral(f, from, t) - amount;
    (excess > 0.0 ? high : low) = t;
    const double slope = f(t);
    double next = slope > 0.0 ? t - excess / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double moved = std::abs(next - t);
    t = next;
    if (moved <= precision) break;
  }
  return t;
}

Mat4 lattice_from_cube(const desc::DensityGrid& grid) {
  const bool at_corners = grid.points == desc::DensityGrid::Points::Corners;
  const Vec3d size = Vec3d(grid.resolution) - Vec3d(at_corners ? 1.0 : 0.0);
  const double first = at_corners ? 0.0 : -0.5;
  Mat4 m;
  m.setScale(size);
  m[3][0] = m[3][1] = m[3][2] = first;
  return m;
}

desc::Vec3i bricks_of(const desc::Vec3i& cells) {
  const auto count = [](int n) { return (n + kBrick - 1) / kBrick; };
  return {count(cells.x), count(cells.y), count(cells.z)};
}

std::size_t product(const desc::Vec3i& n) {
  return static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) *
         static_cast<std::size_t>(n.z);
}

}  // namespace

DensityField::DensityField(const desc::Density& density) : grid_(density.grid) {
  const bool at_corners = grid_->points == desc::DensityGrid::Points::Corners;
  const desc::Vec3i& n = grid_->resolution;
  lattice_from_world_ = density.to_world.inverse() * lattice_from_cube(*grid_);
  low_ = Vec3d(at_corners ? 0.0 : -0.5);
  high_ = Vec3d(n) - Vec3d(at_corners ? 1.0 : 0.5);
  first_ = Cell(at_corners ? 0 : -1);
  last_ = n - Cell(at_corners ? 2 : 1);
  for (const float value : grid_->values) largest_ = std::max(largest_, value);
  find_uniform_bricks();
}

std::uint64_t DensityField::memory(const desc::DensityGrid& grid) {
  // Centers have a cell more along each axis than there are points.
  return product(bricks_of(grid.resolution + desc::Vec3i(1))) * sizeof(Brick);
}

float DensityField::value(int x, int y, int z) const {
  const desc::Vec3i& n = grid_->resolution;
  const bool is_inside = x >= 0 && y >= 0 && z >= 0 && x < n.x && y < n.y && z < n.z;
  if (!is_inside) {
    if (grid_->border == desc::DensityGrid::Border::Zero) return 0.F;
    x = std::clamp(x, 0, n.x - 1);
    y = std::clamp(y, 0, n.y - 1);
    z = std::clamp(z, 0, n.z - 1);
  }
  const auto row =
      static_cast<std::size_t>(z) * static_cast<std::size_t>(n.y) + static_cast<std::size_t>(y);
  return grid_->values[row * static_cast<std::size_t>(n.x) + static_cast<std::size_t>(x)];
}

DensityField::Corners DensityField::corners(const Cell& cell) const {
  const desc::Vec3i& n = grid_->resolution;
  Corners result;
  const int x = cell.x;
  const int y = cell.y;
  const int z = cell.z;
  if (x >= 0 && y >= 0 && z >= 0 && x + 1 < n.x && y + 1 < n.y && z + 1 < n.z) {
    const auto row = static_cast<std::size_t>(n.x);
    const std::size_t plane = row * static_cast<std::size_t>(n.y);
    const float* at = grid_->values.data() + static_cast<std::size_t>(z) * plane +
                      static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x);
    for (std::size_t i = 0; i < 8; ++i) {
      result[i] = static_cast<double>(at[(i & 1U) + ((i >> 1U) & 1U) * row + (i >> 2U) * plane]);
    }
    return result;
  }
  for (int i = 0; i < 8; ++i) {
    result[static_cast<std::size_t>(i)] =
        static_cast<double>(value(x + (i & 1), y + ((i >> 1) & 1), z + (i >> 2)));
  }
  return result;
}

void DensityField::find_uniform_bricks() {
  const desc::Vec3i cells = last_ - first_ + Cell(1);
  brick_count_ = bricks_of(cells);
  bricks_.resize(product(brick_count_));
  std::size_t index = 0;
  for (int bz = 0; bz < brick_count_.z; ++bz) {
    for (int by = 0; by < brick_count_.y; ++by) {
      for (int bx = 0; bx < brick_count_.x; ++bx, ++index) {
        const Cell low = first_ + Cell(bx, by, bz) * kBrick;
        const auto end = [&](int axis) { return std::min(low[axis] + kBrick, last_[axis] + 1); };
        const float uniform = value(low.x, low.y, low.z);
        bool is_uniform = true;
        for (int z = low.z; z <= end(2) && is_uniform; ++z) {
          for (int y = low.y; y <= end(1) && is_uniform; ++y) {
            for (int x = low.x; x <= end(0) && is_uniform; ++x) {
              is_uniform = value(x, y, z) == uniform;
            }
          }
        }
        if (is_uniform) bricks_[index].uniform = uniform;
      }
    }
  }
}

const DensityField::Brick& DensityField::brick(const Cell& cell) const {
  const desc::Vec3i at = (cell - first_) / kBrick;
  const auto row = static_cast<std::size_t>(at.z) * static_cast<std::size_t>(brick_count_.y) +
                   static_cast<std::size_t>(at.y);
  return bricks_[row * static_cast<std::size_t>(brick_count_.x) + static_cast<std::size_t>(at.x)];
}

float DensityField::at(const Vec3& p) const {
  Vec3d place;
  lattice_from_world_.multVecMatrix(Vec3d(p), place);
  Cell cell;
  Vec3d inside;
  for (int axis = 0; axis < 3; ++axis) {
    // Comparisons in this order make a bound of what is no number.
    const double x = std::min(std::max(low_[axis], place[axis]), high_[axis]);
    cell[axis] = std::clamp(static_cast<int>(std::floor(x)), first_[axis], last_[axis]);
    inside[axis] = x - static_cast<double>(cell[axis]);
  }
  return std::max(static_cast<float>(trilinear(corners(cell), inside)), kThinnest * largest_);
}

DensityField::Inside DensityField::clip(const Ray& ray, float distance) const {
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

template <typename Visit>
void DensityField::walk(const Inside& inside, const Visit& visit) const {
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
    const float uniform = brick(cell).uniform;
    const bool is_uniform = uniform >= 0.F;
    const Cell low = is_uniform ? first_ + (cell - first_) / kBrick * kBrick : cell;
    const Cell high = low + Cell(is_uniform ? kBrick : 1);
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
    if (is_uniform) {
      const auto density = [&](double) { return static_cast<double>(uniform); };
      if (visit(density, t, to)) return;
    } else if (to > t) {
      const Corners c = corners(cell);
      const auto density = [&](double at) {
        return std::max(trilinear(c, inside.at(at) - Vec3d(cell)), 0.0);
      };
      if (visit(density, t, to)) return;
    }
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

Column DensityField::along(const Ray& ray, float distance, float most) const {
  const auto limit = static_cast<double>(most);
  double sum = 0.0;
  Column column{distance, 0.F, false};
  walk(clip(ray, distance), [&](const auto& density, double from, double to) {
    const double whole = integral(density, from, to);
    if (sum + whole > limit) {
      const double at = invert_integral(density, from, to, whole, limit - sum);
      column = {static_cast<float>(at), most, true};
      return true;
    }
    sum += whole;
    return false;
  });
  if (!column.reached) column.density = static_cast<float>(sum);
  return column;
}

}  // namespace ajar
