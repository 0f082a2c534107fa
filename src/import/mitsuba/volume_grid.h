#pragma once
#include <vector>

#include "scene/desc/density_grid.h"
#include "scene/desc/node.h"

namespace ajar::mitsuba {

/// Numbers or colours at the points of a lattice, trilinear between them and clamped.
struct VolumeGrid {
  desc::Vec3i resolution{1, 1, 1};
  desc::DensityGrid::Points points = desc::DensityGrid::Points::Centers;
  Mat4 to_world;              ///< transform of the unit cube
  int channels = 1;           ///< 1 or 3
  std::vector<float> values;  ///< channels vary fastest, then x, then y

  bool is_colored() const { return channels == 3; }
  bool has_lattice_of(const VolumeGrid& other) const;
  std::size_t point_count() const { return values.size() / static_cast<std::size_t>(channels); }
  desc::Rgb at(std::size_t point) const;
  /// At a place in the unit cube, or the nearest one in it.
  desc::Rgb at(const Vec3d& place) const;
  /// In the unit cube.
  Vec3d place_of(std::size_t point) const;
  /// Mean of the finite values.
  desc::Rgb mean() const;
};

/// Without values.
desc::DensityGrid lattice_of(const VolumeGrid& grid);

/// Absorption and scattering of extinction `unit` · `extinction` and an albedo, at the points of
/// the former: those of `albedo` if there is one, or `constant_albedo`.
desc::DensityGrid color_grid(const desc::Rgb& unit, const VolumeGrid& extinction,
                             const desc::Rgb& constant_albedo, const VolumeGrid* albedo);

}  // namespace ajar::mitsuba
