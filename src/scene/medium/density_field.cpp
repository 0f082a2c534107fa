#include "scene/medium/density_field.h"

#include <algorithm>

#include "scene/medium/cubic.h"
#include "scene/medium/thinnest.h"

namespace ajar {

DensityField::DensityField(const desc::Density& density)
    : grid_(density.grid), lattice_(density), bricks_(lattice_, [this](const Lattice::Cell& point) {
        return lattice_.value(
            point, [this](std::size_t i) { return grid_->values[i]; }, 0.F);
      }) {
  for (const float value : grid_->values) largest_ = std::max(largest_, value);
}

std::array<double, 8> DensityField::corners(const Lattice::Cell& cell) const {
  const float* values = grid_->values.data();
  return lattice_.corners(
      cell, [values](std::size_t i) { return static_cast<double>(values[i]); }, 0.0);
}

float DensityField::at(const Vec3& p) const {
  const Lattice::Place place = lattice_.locate(p);
  const auto density = static_cast<float>(cubic::trilinear(corners(place.cell), place.inside));
  return std::max(density, kThinnest * largest_);
}

Column DensityField::along(const Ray& ray, float distance, float most) const {
  const auto limit = static_cast<double>(most);
  double sum = 0.0;
  Column column{distance, 0.F, false};
  const auto visit = [&](const auto& density, double from, double to) {
    const double whole = cubic::integral(density, from, to);
    if (sum + whole > limit) {
      const double at = cubic::invert_integral(density, from, to, whole, limit - sum);
      column = {static_cast<float>(at), most, true};
      return true;
    }
    sum += whole;
    return false;
  };
  const Lattice::Inside inside = lattice_.clip(ray, distance);
  lattice_.walk(inside, bricks_,
                [&](const Bricks::Brick& brick, const Lattice::Cell& cell, double from, double to) {
                  if (brick.is_uniform()) {
                    const auto uniform = static_cast<double>(brick.uniform);
                    return visit([uniform](double) { return uniform; }, from, to);
                  }
                  const std::array<double, 8> c = corners(cell);
                  return visit(
                      [&](double at) {
                        return std::max(cubic::trilinear(c, inside.at(at) - Vec3d(cell)), 0.0);
                      },
                      from, to);
                });
  if (!column.reached) column.density = static_cast<float>(sum);
  return column;
}

}  // namespace ajar
