#include "import/mitsuba/volume_grid.h"

#include <algorithm>
#include <cmath>

namespace ajar::mitsuba {

namespace {

bool at_corners(const VolumeGrid& grid) {
  return grid.points == desc::DensityGrid::Points::Corners;
}

}  // namespace

bool VolumeGrid::has_lattice_of(const VolumeGrid& other) const {
  return resolution == other.resolution && points == other.points && to_world == other.to_world;
}

desc::Rgb VolumeGrid::at(std::size_t point) const {
  const float* value = values.data() + point * static_cast<std::size_t>(channels);
  return is_colored() ? desc::Rgb(value[0], value[1], value[2]) : desc::Rgb(value[0]);
}

desc::Rgb VolumeGrid::at(const Vec3d& place) const {
  desc::Vec3i low(0);
  Vec3 share(0.F);
  for (int axis = 0; axis < 3; ++axis) {
    const int last = resolution[axis] - 1;
    const double x = at_corners(*this) ? place[axis] * last : place[axis] * resolution[axis] - 0.5;
    const double clamped = std::min(std::max(0.0, x), static_cast<double>(last));
    low[axis] = std::min(static_cast<int>(clamped), std::max(last - 1, 0));
    share[axis] = static_cast<float>(clamped - low[axis]);
  }
  desc::Rgb sum(0.F);
  for (int corner = 0; corner < 8; ++corner) {
    float weight = 1.F;
    std::size_t index = 0;
    for (int axis = 2; axis >= 0; --axis) {
      const int step = (corner >> axis) & 1;
      weight *= step == 1 ? share[axis] : 1.F - share[axis];
      const int point = std::min(low[axis] + step, resolution[axis] - 1);
      index = index * static_cast<std::size_t>(resolution[axis]) + static_cast<std::size_t>(point);
    }
    if (weight > 0.F) sum += at(index) * weight;
  }
  return sum;
}

Vec3d VolumeGrid::place_of(std::size_t point) const {
  const auto nx = static_cast<std::size_t>(resolution.x);
  const auto ny = static_cast<std::size_t>(resolution.y);
  const Vec3d whole(static_cast<double>(point % nx), static_cast<double>(point / nx % ny),
                    static_cast<double>(point / nx / ny));
  const Vec3d size(resolution);
  return at_corners(*this) ? whole / (size - Vec3d(1.0)) : (whole + Vec3d(0.5)) / size;
}

desc::Rgb VolumeGrid::mean() const {
  Vec3d sum(0.0);
  for (std::size_t i = 0; i < point_count(); ++i) {
    const desc::Rgb value = at(i);
    for (int lane = 0; lane < 3; ++lane) {
      if (std::isfinite(value[lane])) sum[lane] += static_cast<double>(value[lane]);
    }
  }
  return desc::Rgb(sum / static_cast<double>(point_count()));
}

desc::DensityGrid lattice_of(const VolumeGrid& grid) {
  return {grid.resolution, {}, grid.points, desc::DensityGrid::Border::Clamp};
}

desc::DensityGrid color_grid(const desc::Rgb& unit, const VolumeGrid& extinction,
                             const desc::Rgb& constant_albedo, const VolumeGrid* albedo) {
  desc::DensityGrid grid = lattice_of(extinction);
  const std::size_t points = extinction.point_count();
  grid.absorption.reserve(points);
  grid.scattering.reserve(points);
  const bool is_same = albedo != nullptr && albedo->has_lattice_of(extinction);
  Mat4 to_albedo;
  if (albedo != nullptr) to_albedo = extinction.to_world * albedo->to_world.inverse();
  const auto albedo_at = [&](std::size_t point) {
    if (albedo == nullptr) return constant_albedo;
    if (is_same) return albedo->at(point);
    Vec3d place;
    to_albedo.multVecMatrix(extinction.place_of(point), place);
    return albedo->at(place);
  };
  for (std::size_t i = 0; i < points; ++i) {
    const desc::Rgb total = unit * extinction.at(i);
    const desc::Rgb scattering = total * albedo_at(i);
    grid.scattering.push_back(scattering);
    grid.absorption.push_back(total - scattering);
  }
  return grid;
}

}  // namespace ajar::mitsuba
